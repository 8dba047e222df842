// The domain meets soil all around a lining, within the mesh, at nodes that no side holds.

#include "mesh/polygon_measures.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/plan/structures.hpp"
#include "scene/rules/lining/outlines.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/run/places_in_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tremolo::scene {

namespace {

/// A place one cell before the outer face where no soil is.
std::optional<Point> place_without_soil(const Case& scene, const Polygon& outline) {
  const double h = contact_cell_size(scene);
  const double outward = mesh::signed_double_area(outline) > 0.0 ? 1.0 : -1.0;
  std::optional<Point> found;
  for_pieces(outline, box_of(outline).y_max + h, 0.25 * h, [&](Point from, Point to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (found || !(length > 0.0))
      return;
    const double off = outward * h / length;
    const Point before{0.5 * (from.x + to.x) + off * (to.y - from.y),
                       0.5 * (from.y + to.y) - off * (to.x - from.x)};
    if (!in_soil(scene, before))
      found = before;
  });
  return found;
}

} // namespace

void linings_lie_in_ground(const Case& scene, Findings& findings) {
  const bool regions_known =
      findings.sound("region") &&
      std::ranges::none_of(scene.regions, [](const Region& r) { return r.polygon.empty(); });
  if (!mesh_is_sound(scene, findings))
    return;
  constexpr double rounding = 1e-9;
  for (const Lining& lining : scene.linings) {
    if (!outline_is_sound(lining, findings))
      continue;
    const Box& box = scene.mesh.box;
    const Box room = room_around(scene, lining.outline.corners);
    const double least = rounding * box.width();
    if (room.x_min < box.x_min - least || room.x_max > box.x_max + least || room.y_min < box.y_min - least) {
      findings.add(outline_path(lining),
                   fmt::format("'{}' with two cells beside it reaches from x = {:.6g} to {:.6g} and down to "
                               "y = {:.6g}, beyond the sides or the base of the mesh: a larger box holds it",
                               lining.outline.key, room.x_min, room.x_max, room.y_min));
      continue;
    }
    if (!regions_known)
      continue;
    if (const auto bare = place_without_soil(scene, lining.outline.corners))
      findings.add(
          outline_path(lining),
          fmt::format("no [[region]] is at [{:.6g}, {:.6g}], one cell before '{}': a lining has soil "
                      "on all sides; lay it deeper, or take a [[structure]]",
                      bare->x, bare->y, lining.outline.key));
  }
}

} // namespace tremolo::scene
