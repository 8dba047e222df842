#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void structures_have_weight(const Case& scene, Findings& findings) {
  if (scene.structures.empty() || scene.gravity || !findings.sound("stage"))
    return;
  findings.add(scene.structures.front().path,
               "without weight nothing presses a structure to the soil, and friction has "
               "nothing to act on: add a [[stage]] of kind = \"gravity\"");
}

} // namespace tremolo::scene
