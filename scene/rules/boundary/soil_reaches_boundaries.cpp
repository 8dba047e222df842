#include "mesh/cell_size.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tremolo::scene {

namespace {

struct Interval {
  double low;
  double high;
};

/// End of the part of a line, from `start`, that the intervals cover without a gap.
double covered_from(double start, std::vector<Interval> intervals, double tolerance) {
  std::ranges::sort(intervals, {}, &Interval::low);
  double end = start;
  for (const auto& [low, high] : intervals)
    if (low <= end + tolerance)
      end = std::max(end, high);
  return end;
}

/// Edges of all regions on the line where coordinate `on` has the given value, as intervals of coordinate
/// `along`.
std::vector<Interval> edges_on(const Case& scene, double Point::*on, double value, double Point::*along,
                               double tolerance) {
  std::vector<Interval> intervals;
  for (const Region& region : scene.regions)
    for (std::size_t i = 0; i < region.polygon.size(); ++i) {
      const Point a = region.polygon[i];
      const Point b = region.polygon[(i + 1) % region.polygon.size()];
      if (std::abs(a.*on - value) <= tolerance && std::abs(b.*on - value) <= tolerance)
        intervals.push_back({std::min(a.*along, b.*along), std::max(a.*along, b.*along)});
    }
  return intervals;
}

} // namespace

void soil_reaches_boundaries(const Case& scene, Findings& findings) {
  const bool regions_known =
      std::ranges::none_of(scene.regions, [](const Region& r) { return r.polygon.empty(); });
  if (!regions_known || !findings.sound("mesh.box") || !findings.sound("mesh.size") ||
      !findings.sound("region"))
    return;
  const Box& box = scene.mesh.box;
  const double tolerance = mesh::alignment_tolerance(scene.mesh.size);

  const auto check_side = [&](const char* side, double x, double surface) {
    const std::string path =
        !scene.boundary.has_lateral_fields() ? "boundary.sides" : fmt::format("boundary.{}.surface", side);
    if (!findings.sound(path) || !findings.sound("surface.level"))
      return;
    const double top =
        covered_from(box.y_min, edges_on(scene, &Point::x, x, &Point::y, tolerance), tolerance);
    if (std::abs(top - surface) > tolerance)
      findings.add(
          path,
          fmt::format(
              "soil along the {} side, x = {}, reaches from the base to y = {} without a gap, but the free "
              "field's surface lies at y = {}; both must agree",
              side, x, top, surface));
  };
  if (scene.boundary.has_ground_below()) {
    check_side("left", box.x_min, scene.boundary.left.surface);
    check_side("right", box.x_max, scene.boundary.right.surface);
  }

  const double end =
      covered_from(box.x_min, edges_on(scene, &Point::y, box.y_min, &Point::x, tolerance), tolerance);
  if (std::abs(end - box.x_max) > tolerance)
    findings.add(
        "boundary.base",
        fmt::format("soil along the base, y = {}, reaches from the left side to x = {} without a gap, "
                    "must reach to the right side, x = {}",
                    box.y_min, end, box.x_max));
}

} // namespace tremolo::scene
