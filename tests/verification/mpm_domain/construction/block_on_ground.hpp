#pragma once

#include "tests/support/structure_scene.hpp"
#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tremolo::mpm_domain::test {

constexpr double block_weight = 6.0 * 2000.0 * gravity; // N/m

/// A block of 3 by 2 m on ground 16 m wide and 6 m deep. Without it, squares are cut as they are with it.
inline Spec block_on_ground() {
  Spec spec = test_support::flat_ground(16.0, 6.0, 0.5, {1900.0, 5e7, 0.3});
  spec.structures = {test_support::structure(test_support::rectangle(-1.5, 0.0, 1.5, 2.0), 2000.0, 0.5)};
  spec.cut_at_edges = true;
  return spec;
}

/// The smallest and the largest rise of the ground below the block, m.
inline std::pair<double, double> rise_below_block(const Domain& domain) {
  const Particles& p = domain.sets.front();
  std::pair<double, double> found{1.0, -1.0};
  for (std::size_t k = 0; k < p.size(); ++k)
    if (std::abs(p.x[k]) < 1.5 && p.y[k] > -0.25) {
      const double up = p.y[k] - p.y_initial[k];
      found = {std::min(found.first, up), std::max(found.second, up)};
    }
  return found;
}

} // namespace tremolo::mpm_domain::test
