#include "scene/plan/boundary/springs.hpp"

#include "scene/meeting_boxes.hpp"
#include "scene/soils/ground_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tremolo::scene {

namespace {

/// a_n, a_t where the case gives none: a heavy mass vibrates as it should, and a base between two free fields
/// is pulled less (docs/boundaries.md).
constexpr std::array<double, 2> for_equal_sides{1.0, 0.5};
constexpr std::array<double, 2> for_sides_that_differ{0.5, 0.25};

/// y of the highest soil on a vertical line, m.
std::optional<double> ground_surface(const Case& scene, double x) {
  std::optional<double> top;
  for (const Region& region : scene.regions)
    if (const auto levels = crossings(region.polygon, x); !levels.empty())
      top = std::max(top.value_or(levels.front()), levels.front());
  return top;
}

const SpringKeys& keys_of(const Case& scene, Side side) {
  const auto& [sides, left, right, base] = scene.boundary;
  return side == Side::left ? left.springs : side == Side::right ? right.springs : base.springs;
}

/// Whether dashpots stand there, beside which springs can.
bool has_dashpots(const Case& scene, Side side) {
  const auto& [sides, left, right, base] = scene.boundary;
  if (side == Side::base)
    return base.absorber == Absorber::dashpots && scene.boundary.has_ground_below();
  return scene.boundary.has_lateral_fields() &&
         (side == Side::left ? left : right).absorber == Absorber::dashpots;
}

} // namespace

bool base_has_no_total_field(const Case& scene) {
  return scene.boundary.base.form == BaseForm::incident && !scene.boundary.has_lateral_fields();
}

Point spring_centre(const Case& scene) {
  const auto& [sides, left, right, base] = scene.boundary;
  const Point middle{0.5 * (scene.mesh.box.x_min + scene.mesh.box.x_max),
                     0.5 * (left.surface + right.surface)};
  Polygon corners;
  for (const Structure& structure : scene.structures)
    corners.insert(corners.end(), structure.outline.corners.begin(), structure.outline.corners.end());
  if (corners.empty())
    return middle;
  const Box around = box_of(corners);
  const double x = 0.5 * (around.x_min + around.x_max);
  return {x, ground_surface(scene, x).value_or(middle.y)};
}

std::optional<PlannedSprings> springs(const Case& scene, Side side) {
  const SpringKeys& keys = keys_of(scene, side);
  if (keys.given_up || !has_dashpots(scene, side) || (side == Side::base && base_has_no_total_field(scene)))
    return std::nullopt;
  const auto [across, along] =
      keys.stiffness.value_or(scene.boundary.has_equal_sides() ? for_equal_sides : for_sides_that_differ);
  return PlannedSprings{across, along, keys.centre.value_or(spring_centre(scene)),
                        side == Side::base && !scene.boundary.has_equal_sides()};
}

std::string springs_text(const Case& scene) {
  std::string text;
  for (const Side side : {Side::left, Side::right, Side::base})
    if (const auto of_side = springs(scene, side))
      text += fmt::format("{}{}: {:g} and {:g} G/R around ({:g}, {:g}) m{}", text.empty() ? "" : "; ",
                          name(side), of_side->across, of_side->along, of_side->centre.x, of_side->centre.y,
                          of_side->lags ? ", behind a lag" : "");
  return text;
}

} // namespace tremolo::scene
