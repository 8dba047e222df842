#pragma once

// A rough strip footing on clay whose strength grows with depth, c = c_0 + rho z, in slices as high as the
// cells, as the scene cuts soils over depth. Its load is that of slip lines (Davis and Booker 1973).

#include "tests/verification/mpm_domain/limit_loads/footing.hpp"
#include "tests/verification/mpm_domain/limit_loads/slip_lines.hpp"

#include <cmath>
#include <cstddef>
#include <ostream>

namespace tremolo::mpm_domain::test {

struct GrowingClay {
  double cell_size; ///< m
  double poisson;

  friend void PrintTo(const GrowingClay& g, std::ostream* out) {
    *out << "cells of " << g.cell_size << " m, nu " << g.poisson;
  }
};

/// @param load  over that of slip lines
inline bool stands(const GrowingClay& ground, double load) {
  constexpr double surface_strength = 20e3; // Pa
  constexpr double growth = 5e3;            // Pa/m: rho B = c_0
  static const double limit = SlipLines(surface_strength, growth, footing_width).rough();
  Spec spec = footing_on_clay(ground.cell_size, load * limit, 2e8);
  const auto slices = static_cast<std::size_t>(std::lround(clay_depth / ground.cell_size));
  const Soil block = spec.soils.back();
  spec.soils.clear();
  for (std::size_t i = 0; i < slices; ++i) {
    const double z = (static_cast<double>(i) + 0.5) * ground.cell_size;
    spec.soils.push_back({"clay", light_clay(ground.poisson, surface_strength + growth * z)});
    if (i > 0)
      spec.regions.front().cuts.push_back(-static_cast<double>(i) * ground.cell_size);
  }
  spec.soils.push_back(block);
  spec.regions.back().soil = slices;
  return carries_its_weight(spec, rough_patience);
}

} // namespace tremolo::mpm_domain::test
