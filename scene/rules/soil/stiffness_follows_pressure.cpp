#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void stiffness_follows_pressure(const Case& scene, Findings& findings) {
  for (const Soil& soil : domain_soils(scene))
    if (materials::traits(soil.law).follows_pressure)
      findings.add("soil." + soil.name,
                   fmt::format("soil '{}': stiffness grows with pressure; speeds above are those at its "
                               "reference pressure, the time step that of its own weight at the base of the "
                               "model; the run takes those of the stress it has",
                               soil.name));
}

} // namespace tremolo::scene
