#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void tension_has_a_limit(const Case& scene, Findings& findings) {
  for (const Soil& soil : domain_soils(scene))
    if (materials::traits(soil.law).unlimited_tension)
      findings.add(
          "soil." + soil.name,
          fmt::format("soil '{}' has no limit of tension: where a crest would crack open, it hangs together "
                      "and makes the slope stronger; mohr_coulomb takes a tension_cutoff",
                      soil.name));
}

} // namespace tremolo::scene
