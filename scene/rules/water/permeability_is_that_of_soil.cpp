#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

constexpr double most_permeable = 0.1;    // m/s: gravel
constexpr double least_permeable = 1e-13; // m/s: unfissured clay and rock salt
constexpr double day = 86400.0;           // s

} // namespace

void permeability_is_that_of_soil(const Case& scene, Findings& findings) {
  for (const Soil& soil : scene.soils) {
    if (!soil.pores || soil.pores->drainage != materials::Drainage::coupled)
      continue;
    const double k = soil.pores->permeability;
    const auto path = "soil." + soil.name + ".permeability";
    if (k > most_permeable)
      findings.add(
          path, fmt::format("'permeability' = {:g} m/s is that of no soil finer than gravel: m/s are meant; "
                            "{:g} m/day would be {:.3g}, {:g} cm/s would be {:.3g}",
                            k, k, k / day, k, 0.01 * k));
    else if (k < least_permeable)
      findings.add(path,
                   fmt::format("'permeability' = {:g} m/s is that of no soil: the hydraulic conductivity is "
                               "meant; an intrinsic permeability of {:g} m2 would be {:.3g} m/s in water",
                               k, k, 1e7 * k));
  }
}

} // namespace tremolo::scene
