#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void drained_soil_needs_no_permeability(const Case& scene, Findings& findings) {
  for (const Soil& soil : scene.soils)
    if (soil.pores && soil.pores->permeability > 0.0 && soil.pores->drainage != materials::Drainage::coupled)
      findings.add(
          fmt::format("soil.{}.permeability", soil.name),
          fmt::format(
              "'permeability' = {:g} m/s is not used: drainage = \"{}\" of soil '{}' knows no flow{}; "
              "\"coupled\" does",
              soil.pores->permeability, name(soil.pores->drainage), soil.name,
              soil.pores->drainage == materials::Drainage::drained ? ", its pore pressure stays hydrostatic"
                                                                   : ", its water moves with the grains"));
}

} // namespace tremolo::scene
