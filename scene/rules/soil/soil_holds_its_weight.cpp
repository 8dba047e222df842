#include "scene/rules/rules.hpp"
#include "scene/soils/stress_at_rest.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void soil_holds_its_weight(const Case& scene, Findings& findings) {
  constexpr double much =
      2.0; // of the strength: short of it the gravity stage makes a K0 that the soil holds
  if (!scene.gravity)
    return;
  for (const RestingSoil& resting : resting_soils(scene, columns_of_domain(scene)))
    if (resting.mobilised > much)
      findings.add(rest_path(scene, resting),
                   fmt::format("the strength cannot hold the soil's own weight, under which it yields in the "
                               "gravity stage: {}{}",
                               text(scene, resting), strength_doubt(scene, resting)));
}

} // namespace tremolo::scene
