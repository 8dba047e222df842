#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void incident_base_lies_in_halfspace(const Case& scene, Findings& findings) {
  const auto& [sides, left, right, base] = scene.boundary;
  if (base.form != BaseForm::incident || !findings.sound("boundary.base.form") || !findings.sound("mesh.box"))
    return;
  const double top = std::min(base_level(left.surface, layers(scene, left)),
                              base_level(right.surface, layers(scene, right)));
  const double level = scene.mesh.box.y_min;
  if (level > top + 1e-6)
    findings.add(
        "boundary.base.form",
        fmt::format("form = \"incident\" needs a base in the half-space, y <= {}, but [mesh] box ends at y = "
                    "{} within the layers; use form = \"total\" or a deeper box",
                    top, level));
  if (scene.motion.kind == motion::MotionKind::within)
    findings.add(
        "boundary.base.form",
        "form = \"incident\" needs an incident or outcrop motion; one within the ground does not say which "
        "wave came up; use form = \"total\"");
}

} // namespace tremolo::scene
