#include "scene/meeting_boxes.hpp"
#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

/// Whether every corner turns by less than 30 degrees, so that the body rolls where it lies open.
bool is_round(const Polygon& outline) {
  constexpr double most = std::numbers::pi / 6.0;
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point a = outline[i];
    const Point b = outline[(i + 1) % count];
    const Point c = outline[(i + 2) % count];
    const double cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    const double dot = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    if (std::abs(std::atan2(cross, dot)) > most)
      return false;
  }
  return true;
}

/// Whether no soil holds a body from above: its highest point is outside of all soil.
bool lies_open(const Case& scene, const Polygon& outline) {
  const Point top = *std::ranges::max_element(outline, {}, &Point::y);
  return std::ranges::none_of(scene.regions,
                              [top](const Region& region) { return strictly_inside(region.polygon, top); });
}

} // namespace

void round_structures_roll(const Case& scene, Findings& findings) {
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    const Outline& outline = scene.structures[i].outline;
    if (!is_round(outline.corners) || !lies_open(scene, outline.corners))
      continue;
    const Box box = box_of(outline.corners);
    const double cells = std::max(box.width(), box.height()) / contact_cell_size(scene);
    findings.add(
        outline_path(scene, i),
        fmt::format("'{}' is round, lies open and has {:.3g} cells across: what rolls is too slow on gentle "
                    "slopes and small on its cells (half of the way and less at 12 degrees with 20 cells "
                    "across, 0.79 of the acceleration at 20 degrees with 10, 0.98 with 20); how far it rolls "
                    "can be trusted from 20 cells across and 20 degrees on",
                    outline.key, cells));
  }
}

} // namespace tremolo::scene
