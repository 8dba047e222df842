#include "scene/rules/run/places_in_soil.hpp"

#include <algorithm>

namespace tremolo::scene {

bool in_soil(const Case& scene, Point p) {
  return std::ranges::any_of(scene.regions,
                             [p](const Region& region) { return contains(region.polygon, p); });
}

const Structure* structure_around(const Case& scene, Point p) {
  const auto found = std::ranges::find_if(scene.structures, [p](const Structure& structure) {
    const Polygon& outline = structure.outline.corners;
    return !outline.empty() && strictly_inside(outline, p);
  });
  return found == scene.structures.end() ? nullptr : &*found;
}

const Lining* lining_around(const Case& scene, Point p) {
  const auto found = std::ranges::find_if(scene.linings, [p](const Lining& lining) {
    return !lining.outline.corners.empty() && strictly_inside(lining.outline.corners, p);
  });
  return found == scene.linings.end() ? nullptr : &*found;
}

} // namespace tremolo::scene
