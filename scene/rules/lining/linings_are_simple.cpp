#include "scene/rules/lining/outlines.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void linings_are_simple(const Case& scene, Findings& findings) {
  for (const Lining& lining : scene.linings) {
    const auto& [key, corners] = lining.outline;
    if (corners.empty())
      continue;
    if (intersects_itself(corners))
      findings.add(outline_path(lining),
                   fmt::format("'{}' crosses or touches itself: list the corners in order around the lining, "
                               "each once",
                               key));
    else if (!(area(corners) > 0.0))
      findings.add(outline_path(lining), fmt::format("'{}' has no area", key));
  }
}

} // namespace tremolo::scene
