#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void boxes_suit_order(const Case& scene, Findings& findings) {
  if (scene.mesh.particle_boxes == ParticleBoxes::deforming && scene.time.order == StepOrder::usf &&
      findings.sound("mesh.particle_boxes") && findings.sound("time.order"))
    findings.add(
        "mesh.particle_boxes",
        "'particle_boxes' = \"deforming\" needs order = \"musl\" or \"usl\" in [time]: with \"usf\" boxes "
        "would change within a step");
}

} // namespace tremolo::scene
