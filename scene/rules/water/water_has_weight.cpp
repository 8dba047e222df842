#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void water_has_weight(const Case& scene, Findings& findings) {
  if (!scene.water || scene.gravity || !findings.sound("stage"))
    return;
  findings.add("water", "pore pressure and effective stress begin with those that gravity makes: add a "
                        "[[stage]] of kind = \"gravity\"");
}

} // namespace tremolo::scene
