#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

bool carries_any_tension(const materials::Law& law) {
  if (const auto* soil = std::get_if<materials::MohrCoulomb>(&law))
    return soil->friction_peak == 0.0 && !soil->tension_cutoff;
  if (const auto* soil = std::get_if<materials::DruckerPrager>(&law))
    return soil->friction == 0.0;
  return std::holds_alternative<materials::MultiYieldClay>(law);
}

} // namespace

void tension_has_a_limit(const Case& scene, Findings& findings) {
  for (const Soil& soil : domain_soils(scene))
    if (carries_any_tension(soil.law))
      findings.add(
          "soil." + soil.name,
          fmt::format("soil '{}' has no limit of tension: where a crest would crack open, it hangs together "
                      "and makes the slope stronger; mohr_coulomb takes a tension_cutoff",
                      soil.name));
}

} // namespace tremolo::scene
