#pragma once

// The part of each square of the initial lattice of particles that is soil. The domain is filled by it, and a
// plan counts by it.

#include "mesh/polygon.hpp"
#include "mesh/quadtree.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

/// The part of a particle's square that is soil.
struct Plot {
  double x, y; ///< of its centroid, m
  double area; ///< m2
};

/// Whether the soil of a square becomes a particle. Slivers give theirs to the nearest particle: no node
/// would feel their stress, so nothing would hold it back from growing without bounds.
inline bool is_particle(const Plot& plot, double size) {
  constexpr double least_share = 0.1;
  return plot.area >= least_share * size * size;
}

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

/// Adds the positions where a polygon's edges cross a level in a square.
template <typename Polygon>
void add_crossings(const Polygon& polygon, double level, const mesh::Rectangle& square,
                   std::vector<double>& positions) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const auto& a = polygon[j];
    const auto& b = polygon[i];
    if ((a.y > level) == (b.y > level))
      continue;
    const double position = a.x + (level - a.y) / (b.y - a.y) * (b.x - a.x);
    if (position > square.x_min && position < square.x_max)
      positions.push_back(position);
  }
}

/// The part of the square around (x, y) that lies in one of the regions and in none of the structures.
/// Without structures it is all of the square or nothing, by its centre: the surface of the soil is then a
/// staircase of squares, which waves do not mind, but bodies do. Squares that edges run through are cut.
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
  // Strips between the corners' levels, four to each; along the middle of a strip soil begins and ends where
  // edges cross it. So the area is exact unless edges cross each other.
  constexpr int parts = 4;
  std::vector<double> levels{square.y_min, square.y_max};
  const auto over_polygons = [&](const auto& act) {
    for (const auto& polygon : regions)
      act(polygon);
    for (const auto& polygon : structures)
      act(polygon);
  };
  over_polygons([&](const auto& polygon) {
    for (const auto& corner : polygon)
      if (corner.y > square.y_min && corner.y < square.y_max)
        levels.push_back(corner.y);
  });
  std::ranges::sort(levels);
  Plot plot{0.0, 0.0, 0.0};
  std::vector<double> ends;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k)
    for (int part = 0; part < parts; ++part) {
      const double width = (levels[k + 1] - levels[k]) / parts;
      const double py = levels[k] + (part + 0.5) * width;
      ends.assign({square.x_min, square.x_max});
      over_polygons([&](const auto& polygon) { add_crossings(polygon, py, square, ends); });
      std::ranges::sort(ends);
      for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
        const double px = 0.5 * (ends[e] + ends[e + 1]);
        const double area = width * (ends[e + 1] - ends[e]);
        if (!is_soil(px, py))
          continue;
        plot.area += area;
        plot.x += area * px;
        plot.y += area * py;
      }
    }
  if (plot.area < 1e-12 * size * size)
    return {x, y, 0.0};
  if (plot.area > (1.0 - 1e-12) * size * size)
    return {x, y, size * size};
  return {plot.x / plot.area, plot.y / plot.area, plot.area};
}

} // namespace tremolo::mpm_domain
