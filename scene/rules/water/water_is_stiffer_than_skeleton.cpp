#include "scene/plan/wet_soils.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

/// If K_f/n is below the modulus of the skeleton, the grains carry most of the load that the water should:
/// soil with so much air does not liquefy.
void water_is_stiffer_than_skeleton(const Case& scene, Findings& findings) {
  constexpr double kilo = 1e3;
  for (const Soil& soil : soils_below_table(scene)) {
    if (!soil.pores || soil.pores->drainage == materials::Drainage::drained)
      continue;
    const double skeleton = materials::elasticity(soil.law).p_modulus();
    const double water = materials::pore_stiffness(*soil.pores, scene.water->fluid);
    const double given = scene.water->fluid.bulk_modulus;
    if (water < skeleton)
      findings.add("water.bulk_modulus",
                   fmt::format("'bulk_modulus' = {:g} Pa makes the water in the pores of soil '{}', K_f/n = "
                               "{:.3g} Pa, softer than its skeleton, {:.3g} Pa: hardly any pore pressure "
                               "rises; water without air has 2.2e9 Pa{}",
                               given, soil.name, water, skeleton,
                               kilo * given < 1e10
                                   ? fmt::format(", {:g} kPa would be {:.4g}", given, kilo * given)
                                   : ""));
  }
}

} // namespace tremolo::scene
