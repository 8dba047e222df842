// A load acts on the uppermost soil between its ends, where there must be no structure. Free fields do not
// contain the load, so that it must not reach a side that is driven by one.

#include "scene/rules/rules.hpp"
#include "scene/soils/ground_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace tremolo::scene {

namespace {

/// Steeper ground than 2:1 is a wall: a load on it has no place among the uppermost particles.
constexpr double steepest = 2.0;

/// y of the ground's surface at x (m); none beside the ground.
std::optional<double> surface_at(const Case& scene, double x) {
  const GroundColumn ground = ground_of_domain(scene, x);
  return ground.empty() ? std::nullopt : std::optional(ground.front().top);
}

/// Why the ground cannot carry the load; empty if it can.
std::string lack_of_ground(const Case& scene, const LoadStage& load) {
  const Box& box = scene.mesh.box;
  if (load.x_min < box.x_min || load.x_max > box.x_max)
    return fmt::format("lies beside the model, which goes from x = {:g} to {:g} m: move it inside", box.x_min,
                       box.x_max);
  // Between the particles' columns there is nothing that they could miss.
  const int columns =
      std::max(1, static_cast<int>(std::ceil((load.x_max - load.x_min) / scene.mesh.particle_size())));
  const double width = (load.x_max - load.x_min) / columns;
  std::optional<double> before;
  for (int c = 0; c < columns; ++c) {
    const double x = load.x_min + (c + 0.5) * width;
    const auto surface = surface_at(scene, x);
    if (!surface)
      return fmt::format("lies beside the ground: there is no soil at x = {:g} m", x);
    if (before && std::abs(*surface - *before) > steepest * width)
      return fmt::format(
          "reaches over a wall of {:.3g} m at x = {:g} m, where no soil carries it from above: "
          "end it there",
          std::abs(*surface - *before), x - 0.5 * width);
    before = surface;
  }
  return {};
}

/// The side that the load reaches and a free field drives; empty if there is none.
std::string reached_side(const Case& scene, const LoadStage& load) {
  if (!scene.boundary.has_lateral_fields())
    return {};
  const Box& box = scene.mesh.box;
  const double near = 1e-9 * box.width();
  if (load.x_min < box.x_min + near)
    return "left";
  return load.x_max > box.x_max - near ? "right" : "";
}

/// The interval from its left end to its right one, m.
std::pair<double, double> extent(const Structure& structure) {
  const auto [left, right] = std::ranges::minmax(structure.outline.corners, {}, &Point::x);
  return {left.x, right.x};
}

/// A structure above or below the load; null: there is none.
const Structure* structure_above(const Case& scene, const LoadStage& load) {
  const auto found = std::ranges::find_if(scene.structures, [&](const Structure& structure) {
    if (structure.outline.corners.empty())
      return false;
    const auto [left, right] = extent(structure);
    return load.x_min < right && load.x_max > left;
  });
  return found == scene.structures.end() ? nullptr : &*found;
}

} // namespace

void loads_act_on_ground(const Case& scene, Findings& findings) {
  if (scene.loads.empty() || !mesh_is_sound(scene, findings) || !findings.sound("region"))
    return;
  for (const LoadStage& load : scene.loads) {
    if (load.on_structure() || !findings.sound(load.path + ".x_m"))
      continue;
    const auto refuse = [&](const std::string& why) {
      findings.add(load.path + ".x_m", fmt::format("the load '{}' {}", load.name, why));
    };
    if (const std::string lack = lack_of_ground(scene, load); !lack.empty())
      refuse(lack);
    else if (const std::string side = reached_side(scene, load); !side.empty())
      refuse(fmt::format("reaches the {} side of the model, whose free field does not have it: end it "
                         "before, or take sides that are periodic or a container",
                         side));
    if (const Structure* const above = structure_above(scene, load))
      refuse(fmt::format("lies where the structure '{}' is, from x = {:g} to {:g} m, and acts on soil "
                         "alone: end it beside the structure, or load that one, by 'structure'",
                         above->name, extent(*above).first, extent(*above).second));
  }
}

} // namespace tremolo::scene
