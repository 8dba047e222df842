#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/soil_report.hpp"

namespace tremolo::scene {

void backbone_has_given_strength(const Case& scene, Findings& findings) {
  for (const auto& [name, soil] : named_soils(scene))
    if (const auto compared = implied_strength(soil))
      findings.add("soil." + name + ".shear_strength", compared->text);
}

} // namespace tremolo::scene
