#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void linings_have_weight(const Case& scene, Findings& findings) {
  if (scene.linings.empty() || scene.gravity || !findings.sound("stage"))
    return;
  findings.add(
      scene.linings.front().path,
      "without weight nothing presses the soil to a lining, and friction has nothing to act on: add a "
      "[[stage]] of kind = \"gravity\"");
}

} // namespace tremolo::scene
