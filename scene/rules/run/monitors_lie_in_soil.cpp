#include "scene/rules/result_names.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/run/places_in_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace tremolo::scene {

void monitors_lie_in_soil(const Case& scene, Findings& findings) {
  const bool regions_known =
      std::ranges::none_of(scene.regions, [](const Region& r) { return r.polygon.empty(); });
  check_result_names("monitor", scene.monitors, findings);
  for (std::size_t i = 0; i < scene.monitors.size(); ++i) {
    const Point point = scene.monitors[i].point;
    const std::string path = fmt::format("monitor[{}].point", i);
    if (!regions_known || !findings.sound("region") || !findings.sound(path) || scene.monitors[i].structure ||
        !findings.sound(fmt::format("monitor[{}].structure", i)))
      continue;
    if (!in_soil(scene, point))
      findings.add(path, fmt::format("'point' [{}, {}] lies in no region", point.x, point.y));
    else if (const Structure* structure = structure_around(scene, point))
      findings.add(path, fmt::format("'point' [{1}, {2}] lies in structure '{0}', where no soil is; with "
                                     "structure = \"{0}\" the monitor moves with it",
                                     structure->name, point.x, point.y));
    else if (const Lining* lining = lining_around(scene, point))
      findings.add(path, fmt::format("'point' [{}, {}] lies in lining '{}', where no soil is", point.x,
                                     point.y, lining->name));
  }
}

} // namespace tremolo::scene
