#include "scene/plan/lining/beam_outline.hpp"
#include "scene/rules/lining/outlines.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

void hinges_lie_on_linings(const Case& scene, Findings& findings) {
  constexpr double rounding = 1.1; // a circle's polygon lies slightly off the circle
  for (const Lining& lining : scene.linings) {
    const std::string path = lining.path + ".hinges";
    if (!outline_is_sound(lining, findings) || !findings.sound(path) ||
        !findings.sound(lining.path + ".thickness"))
      continue;
    for (const Point& hinge : lining.hinges) {
      const Point on = nearest_on(lining.outline.corners, hinge);
      const double away = std::hypot(on.x - hinge.x, on.y - hinge.y);
      if (away > rounding * lining.thickness)
        findings.add(path, fmt::format("the hinge at [{:g}, {:g}] is {:.3g} m from '{}', must be within the "
                                       "lining: at most its thickness, {:g} m, from its outer face",
                                       hinge.x, hinge.y, away, lining.outline.key, lining.thickness));
    }
  }
}

} // namespace tremolo::scene
