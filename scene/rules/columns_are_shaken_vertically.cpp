#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void columns_are_shaken_vertically(const Case& scene, Findings& findings) {
  if (scene.motion.angle_deg == 0.0 || !findings.sound("motion.angle_deg"))
    return;
  const auto check = [&](SourceModel model, const char* path) {
    if (model == SourceModel::column && findings.sound(path))
      findings.add(
          path,
          fmt::format("model = \"column\" knows vertical incidence only, but [motion] angle_deg = {}; use "
                      "model = \"wave\" or angle_deg = 0",
                      scene.motion.angle_deg));
  };
  check(scene.boundary.left.model, "boundary.left.model");
  check(scene.boundary.right.model, "boundary.right.model");
  check(scene.boundary.base.model, "boundary.base.model");
}

} // namespace tremolo::scene
