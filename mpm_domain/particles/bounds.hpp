#pragma once

#include "mesh/quadtree.hpp"

#include <algorithm>
#include <limits>

namespace tremolo::mpm_domain {

/// A box around nothing, which grows with the first point.
inline constexpr mesh::Rectangle around_nothing{
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

/// Lets a box reach around a point, m.
inline void reach_around(mesh::Rectangle& box, double x, double y) {
  box = {std::min(box.x_min, x), std::min(box.y_min, y), std::max(box.x_max, x), std::max(box.y_max, y)};
}

} // namespace tremolo::mpm_domain
