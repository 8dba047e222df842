#pragma once

// Slopes 10 m high of one soil, on their base or on ground of the same soil.

#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain::test {

inline constexpr double height = 10.0; // m
inline constexpr double degree = std::numbers::pi / 180.0;

struct Slope {
  double angle_deg;
  double depth_factor; ///< depth of the base below the crest over the height
  double cell_size;    ///< m
};

/// Flat ground reaches over more than the depth of the base on either side. A slope on its base has none
/// before its toe, which stands clear of the side.
inline Spec spec_of(const Slope& slope, const materials::Law& law) {
  const double width = height / std::tan(slope.angle_deg * degree);
  const double base = height * (1.0 - slope.depth_factor);
  const bool on_base = slope.depth_factor == 1.0;
  const double toe = on_base ? 2.0 : 2.0 * std::ceil(0.6 * height * slope.depth_factor);
  const double right =
      2.0 * std::ceil(0.5 * (toe + width) + 0.75 * height * std::max(slope.depth_factor, 1.5));
  const double left = on_base ? toe : 0.0;
  Spec spec;
  spec.box = {0.0, base, right, height};
  spec.cell_size = slope.cell_size;
  spec.gravity = gravity;
  spec.soils = {{"soil", law}};
  spec.regions = {
      {0, {{left, base}, {right, base}, {right, height}, {toe + width, height}, {toe, 0.0}, {left, 0.0}}}};
  if (on_base)
    spec.regions.front().polygon.pop_back();
  return spec;
}

} // namespace tremolo::mpm_domain::test
