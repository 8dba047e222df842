// A closed beam with three hinges has only the three motions of a rigid body; each further hinge adds one
// that strains nothing, which the ground alone resists.

#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void hinged_linings_hold(const Case& scene, Findings& findings) {
  for (const Lining& lining : scene.linings)
    if (lining.hinges.size() > 3)
      findings.add(
          lining.path + ".hinges",
          fmt::format("with {} hinges the lining is a mechanism that only the ground around it holds; "
                      "it stands free of the ground with three at most",
                      lining.hinges.size()));
}

} // namespace tremolo::scene
