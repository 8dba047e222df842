// Loads, monitors, lines, sliding masses and props ride on particles from the start on: those must not be
// removed, and what is placed must not bury a load, or become part of a sliding mass.

#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tremolo::scene {

namespace {

/// A text on the item that lies in a region; empty if there is none.
std::string rider_in(const Case& scene, const Region& region) {
  for (const Monitor& monitor : scene.monitors)
    if (!monitor.structure && contains(region.polygon, monitor.point))
      return fmt::format("the monitor '{}'", monitor.name);
  for (const Line& line : scene.lines)
    if (line.spacing > 0.0 && std::ranges::any_of(points_along(line.from, line.to, line.spacing),
                                                  [&](Point p) { return contains(region.polygon, p); }))
      return fmt::format("the line '{}'", line.name);
  return {};
}

/// The prop that holds on to soil in a region, in words: soil within about a cell of its end.
std::string prop_in(const Case& scene, const Region& region) {
  const double reach = contact_cell_size(scene) * (1.0 + 1.0 / scene.mesh.particles_per_cell);
  for (const Prop& prop : scene.props)
    for (const Prop::End* end : {&prop.from, &prop.to})
      if (end->structure.empty() && (contains(region.polygon, end->position) ||
                                     std::ranges::any_of(circle(end->position, reach), [&](Point p) {
                                       return contains(region.polygon, p);
                                     })))
        return fmt::format("the prop '{}'", prop.name);
  return {};
}

/// The sliding mass that a region reaches into, in words.
std::string mass_at(const Case& scene, const Region& region) {
  for (const SlidingMass& mass : scene.sliding_masses) {
    const Polygon& outline = mass.outline.corners;
    const auto one_in = [](const Polygon& corners, const Polygon& polygon) {
      return std::ranges::any_of(corners, [&](Point p) { return contains(polygon, p); });
    };
    if (one_in(outline, region.polygon) || one_in(region.polygon, outline))
      return fmt::format("the sliding mass '{}'", mass.name);
  }
  return {};
}

/// The load above or below a region, in words.
std::string load_at(const Case& scene, const Region& region) {
  const auto [left, right] = std::ranges::minmax(region.polygon, {}, &Point::x);
  for (const LoadStage& load : scene.loads)
    if (!load.on_structure() && load.x_min < right.x && load.x_max > left.x)
      return fmt::format("the load '{}'", load.name);
  return {};
}

} // namespace

void earthworks_spare_what_rides_on_soil(const Case& scene, Findings& findings) {
  for (const Earthwork& work : scene.earthworks) {
    const auto refuse = [&](const std::vector<Region>& regions, const char* key, const auto& find) {
      for (const Region& region : regions)
        if (const std::string what = region.polygon.empty() ? std::string() : find(scene, region);
            !what.empty())
          findings.add(work.path + key, fmt::format("'{}' lies where {} is, which rides on the soil that the "
                                                    "ground is shaken with",
                                                    region.name, what));
    };
    refuse(work.removed, ".remove", rider_in);
    refuse(work.removed, ".remove", prop_in);
    refuse(work.removed, ".remove", mass_at);
    refuse(work.removed, ".remove", load_at);
    refuse(work.placed, ".place", mass_at);
    refuse(work.placed, ".place", load_at);
  }
}

} // namespace tremolo::scene
