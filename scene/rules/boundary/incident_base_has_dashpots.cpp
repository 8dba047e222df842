#include "scene/rules/rules.hpp"

namespace tremolo::scene {

void incident_base_has_dashpots(const Case& scene, Findings& findings) {
  if (const auto& base = scene.boundary.base;
      base.form == BaseForm::incident && base.absorber == Absorber::matched_layer)
    findings.add(
        "boundary.base.absorber",
        "the base takes the incident wave alone, so all that comes down again meets its matched layer, "
        "whose ends do not know it: form = \"blended\", or dashpots, err less there "
        "(docs/boundaries.md)");
}

} // namespace tremolo::scene
