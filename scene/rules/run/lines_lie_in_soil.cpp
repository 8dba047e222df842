#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/run/places_in_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

/// The file holds the names of all columns of a line in one attribute of at most 64 KiB.
constexpr double most_points = 100;

} // namespace

void lines_lie_in_soil(const Case& scene, Findings& findings) {
  check_result_names("line", scene.lines, findings);
  const bool regions_known =
      findings.sound("region") &&
      std::ranges::none_of(scene.regions, [](const Region& r) { return r.polygon.empty(); });
  for (std::size_t i = 0; i < scene.lines.size(); ++i) {
    const Line& line = scene.lines[i];
    const auto path = [i](std::string_view key) { return fmt::format("line[{}].{}", i, key); };
    if (!findings.sound(path("from")) || !findings.sound(path("to")) || !findings.sound(path("spacing")) ||
        !findings.sound("mesh.size"))
      continue;
    const double length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
    if (!(length > 0.0)) {
      findings.add(path("to"),
                   fmt::format("'to' [{}, {}] is 'from': the line has no length", line.to.x, line.to.y));
      continue;
    }
    if (length > (most_points - 1.0) * line.spacing) {
      findings.add(path("spacing"),
                   fmt::format("points every {} m along {:.6g} m are more than {}: 'spacing' must be at "
                               "least {:.4g} m, or make several lines of it",
                               line.spacing, length, most_points, length / (most_points - 1.0)));
      continue;
    }
    if (!regions_known)
      continue;
    for (const Point& point : points_along(line.from, line.to, line.spacing)) {
      if (const Structure* structure = structure_around(scene, point); structure != nullptr) {
        findings.add(path("from"),
                     fmt::format("the line crosses structure '{}' at [{:.6g}, {:.6g}], where no soil is",
                                 structure->name, point.x, point.y));
        break;
      }
      if (const Lining* lining = lining_around(scene, point); lining != nullptr) {
        findings.add(path("from"),
                     fmt::format("the line crosses lining '{}' at [{:.6g}, {:.6g}], where no soil is",
                                 lining->name, point.x, point.y));
        break;
      }
      if (!in_soil(scene, point)) {
        findings.add(path("from"),
                     fmt::format("the line leaves the soil: its point [{:.6g}, {:.6g}] lies in no region",
                                 point.x, point.y));
        break;
      }
    }
  }
}

} // namespace tremolo::scene
