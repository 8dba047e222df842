#include "mpm_domain/gravity/held_soil.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

using Polygon = std::vector<Vector>;

/// The part of a polygon on one side of a vertical (Sutherland and Hodgman 1974). Where it falls into pieces,
/// they stay joined along the vertical, which encloses nothing.
template <class Compare>
Polygon clipped(const Polygon& polygon, double x, const Compare& beyond) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % polygon.size()];
    if (!beyond(a.x, x))
      part.push_back(a);
    if (beyond(a.x, x) != beyond(b.x, x))
      part.push_back({x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)});
  }
  return part;
}

/// Appends to a list a copy of all that it holds.
template <class T>
void repeat(std::vector<T>& list) {
  const std::vector<T> once = list;
  list.insert(list.end(), once.begin(), once.end());
}

} // namespace

Spec held_beside(Spec spec, double x_min, double x_max) {
  const std::size_t soils = spec.soils.size();
  repeat(spec.soils); // the second half is elastic
  for (std::size_t s = soils; s < spec.soils.size(); ++s) {
    spec.soils[s].law = materials::LinearElastic{materials::elasticity(spec.soils[s].law)};
    spec.soils[s].finer_laws.clear();
  }
  for (Structure& structure : spec.structures) {
    repeat(structure.friction);
    repeat(structure.adhesion);
  }
  std::vector<Region> regions;
  for (const Region& region : spec.regions) {
    regions.push_back(region); // all of it elastic, and over it its part that may fail
    regions.back().soil += soils;
    const Polygon part = clipped(clipped(region.polygon, x_min, std::less<>()), x_max, std::greater<>());
    if (part.size() > 2)
      regions.push_back({region.soil, part, region.cuts});
  }
  spec.regions = regions;
  return spec;
}

double distance_to_soil(const Ground& ground, Vector point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Particles& set : ground.sets_of_soil())
    for (std::size_t k = 0; k < set.size(); ++k)
      nearest = std::min(nearest, std::hypot(set.x[k] - point.x, set.y[k] - point.y));
  return nearest;
}

} // namespace tremolo::mpm_domain
