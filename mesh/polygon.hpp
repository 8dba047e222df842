#pragma once

#include <cstddef>

namespace tremolo::mesh {

/// Whether a point lies inside a polygon, by the even-odd rule; undecided on the outline itself.
/// @param polygon  corners with members x and y, in either sense of rotation; the last is joined to the first
template <class Polygon>
bool inside(const Polygon& polygon, double x, double y) {
  bool odd = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const auto& a = polygon[i];
    const auto& b = polygon[j];
    if ((a.y > y) != (b.y > y) && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x)
      odd = !odd;
  }
  return odd;
}

} // namespace tremolo::mesh
