#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void soil_is_that_of_halfspace(const Case& scene, Findings& findings) {
  if (!scene.profile.empty() || !scene.boundary.has_ground_below())
    return;
  for (const Soil& soil : domain_soils(scene)) {
    const auto& elastic = materials::elasticity(soil.law);
    const auto& half = scene.halfspace;
    if (elastic.density != half.density || elastic.young != half.young || elastic.poisson != half.poisson)
      findings.add("soil." + soil.name,
                   fmt::format("soil '{}' differs elastically from [halfspace]: where it lies at a boundary, "
                               "the free field there is not that of the domain",
                               soil.name));
  }
}

} // namespace tremolo::scene
