#pragma once

// What structures leave of the squares that particles fill at the start. The domain is filled by it, and a
// plan counts by it.

#include "mesh/polygon_measures.hpp"

namespace tremolo::mpm_domain {

/// The part of a particle's square that no structure takes.
struct Plot {
  double x, y; ///< of its centroid, m
  double area; ///< m2; 0: too little for a particle
};

/// Squares that structures leave less of than this share carry no particle.
inline constexpr double least_plot = 0.01;

/// The part of a square around (x, y) outside of polygons that do not overlap.
/// @param size  of the square, m
template <class Outlines>
Plot plot_outside(const Outlines& outlines, double x, double y, double size) {
  const double l = 0.5 * size;
  double area = size * size;
  double first_x = 0.0; // moments about (x, y)
  double first_y = 0.0;
  for (const auto& outline : outlines) {
    const mesh::PolygonMeasures taken = mesh::measures(mesh::part_in(outline, {x - l, y - l, x + l, y + l}));
    area -= taken.area;
    first_x -= taken.area * (taken.x - x);
    first_y -= taken.area * (taken.y - y);
  }
  if (area < least_plot * size * size)
    return {x, y, 0.0};
  return {x + first_x / area, y + first_y / area, area};
}

} // namespace tremolo::mpm_domain
