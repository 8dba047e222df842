#pragma once

// Which part of the squares that particles fill at the start is soil. The domain is filled by it, and a plan
// counts by it.

#include "mesh/polygon.hpp"
#include "mesh/quadtree.hpp"

#include <algorithm>
#include <cstddef>

namespace tremolo::mpm_domain {

/// The part of a particle's square that is soil.
struct Plot {
  double x, y; ///< of its centroid, m
  double area; ///< m2; 0: too little for a particle
};

/// Squares with less soil than this share carry no particle.
inline constexpr double least_plot = 0.01;

/// Whether an edge of a polygon runs through a square.
template <typename Polygon>
bool cuts(const Polygon& polygon, const mesh::Rectangle& square) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    double first = 0.0; // of the part of the edge within, as shares of it
    double last = 1.0;
    const auto clip = [&](double from, double to, double low, double high) {
      const double way = to - from;
      if (way == 0.0) {
        if (from <= low || from >= high)
          last = -1.0;
        return;
      }
      const double a = (low - from) / way;
      const double b = (high - from) / way;
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    };
    clip(polygon[j].x, polygon[i].x, square.x_min, square.x_max);
    clip(polygon[j].y, polygon[i].y, square.y_min, square.y_max);
    if (first < last)
      return true;
  }
  return false;
}

/// What of the square around (x, y) lies in one of the regions and in none of the structures. Without
/// structures it is all of the square or nothing, by its centre: the surface of the soil is then a staircase
/// of squares, which waves do not mind, but bodies do. Squares that edges run through are sampled.
/// @param regions, structures  polygons
/// @param size                 of the square, m
template <class Regions, class Structures>
Plot plot_of(const Regions& regions, const Structures& structures, double x, double y, double size) {
  const auto in_one = [](const auto& polygons, double px, double py) {
    return std::ranges::any_of(polygons, [&](const auto& polygon) { return mesh::inside(polygon, px, py); });
  };
  const auto is_soil = [&](double px, double py) {
    return in_one(regions, px, py) && !in_one(structures, px, py);
  };
  const mesh::Rectangle square{x - 0.5 * size, y - 0.5 * size, x + 0.5 * size, y + 0.5 * size};
  const auto cut_by = [&](const auto& polygons) {
    return std::ranges::any_of(polygons, [&](const auto& polygon) { return cuts(polygon, square); });
  };
  if (structures.empty() || !(cut_by(regions) || cut_by(structures)))
    return {x, y, is_soil(x, y) ? size * size : 0.0};
  constexpr int samples = 32; // a direction
  Plot plot{0.0, 0.0, 0.0};
  int hits = 0;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const double px = square.x_min + (i + 0.5) * size / samples;
      const double py = square.y_min + (j + 0.5) * size / samples;
      if (is_soil(px, py)) {
        plot.x += px;
        plot.y += py;
        ++hits;
      }
    }
  if (hits == samples * samples)
    return {x, y, size * size};
  if (hits < least_plot * samples * samples)
    return {x, y, 0.0};
  return {plot.x / hits, plot.y / hits, size * size * hits / (samples * samples)};
}

} // namespace tremolo::mpm_domain
