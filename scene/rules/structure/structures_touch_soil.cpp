#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace tremolo::scene {

namespace {

/// Whether two outlines, which do not overlap, meet in a corner of one of them.
bool meet(const Polygon& one, const Polygon& other) {
  const auto corner_in = [](const Polygon& corners, const Polygon& polygon) {
    return std::ranges::any_of(corners, [&](const Point& p) { return contains(polygon, p); });
  };
  return corner_in(one, other) || corner_in(other, one);
}

/// For each structure, whether it touches soil or stands on one that does.
std::vector<bool> structures_with_support(const Case& scene) {
  std::vector<bool> supported;
  for (std::size_t i = 0; i < scene.structures.size(); ++i)
    supported.push_back(!points_on_soil(scene, i).empty());
  for (bool grows = true; std::exchange(grows, false);)
    for (std::size_t i = 0; i < supported.size(); ++i)
      for (std::size_t j = 0; j < supported.size() && !supported[i]; ++j) {
        const auto& [one, other] = std::tie(scene.structures[i], scene.structures[j]);
        if (supported[j] && meet(one.outline.corners, other.outline.corners))
          supported[i] = grows = true;
      }
  return supported;
}

} // namespace

void structures_touch_soil(const Case& scene, Findings& findings) {
  const bool regions_known =
      std::ranges::none_of(scene.regions, [](const Region& r) { return r.polygon.empty(); });
  if (!regions_known || !findings.sound("region") || !mesh_is_sound(scene, findings))
    return;
  for (std::size_t i = 0; i < scene.structures.size(); ++i)
    if (!outline_is_sound(scene, i, findings))
      return;
  const std::vector<bool> supported = structures_with_support(scene);
  for (std::size_t i = 0; i < scene.structures.size(); ++i)
    if (!supported[i])
      findings.add(
          outline_path(scene, i),
          fmt::format("'{}' touches no soil: a structure stands on or in a [[region]], or on another "
                      "one that does",
                      scene.structures[i].outline.key));
}

} // namespace tremolo::scene
