#pragma once

// A line of points from left to right, as a phreatic line is given. The domain and the scene read it.

#include <algorithm>

namespace tremolo::mpm_domain {

/// Level (m) and slope (1) of a line at a point.
struct OnLine {
  double level = 0.0;
  double slope = 0.0;
};

/// Beyond its ends, a line is level.
/// @param line  points with x and y, at least one, x rising
template <class Points>
OnLine on_line(const Points& line, double x) {
  const auto right = std::ranges::upper_bound(line, x, {}, [](const auto& point) { return point.x; });
  if (right == line.begin())
    return {line.front().y, 0.0};
  if (right == line.end())
    return {line.back().y, 0.0};
  const auto& a = *(right - 1);
  const double slope = (right->y - a.y) / (right->x - a.x);
  return {a.y + slope * (x - a.x), slope};
}

} // namespace tremolo::mpm_domain
