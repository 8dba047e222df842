#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <string>

namespace tremolo::scene {

namespace {

std::string in_words(const materials::Backbone& backbone) {
  if (const auto& shape = backbone.shape)
    return fmt::format("theta1 to theta3 = {:.4g}, {:.4g}, {:.4g}", shape->first, shape->second,
                       shape->third);
  return fmt::format("reference_strain = {:.4g}, beta = {:.4g}, exponent = {:.4g}", backbone.reference_strain,
                     backbone.beta, backbone.exponent);
}

std::string in_words(const materials::LoopReduction& loops) {
  if (!loops.any())
    return "the damping of the Masing rules";
  return fmt::format("with p1 to p3 = {:.3g}, {:.3g}, {:.3g} the damping of loops", loops.at_small_strain,
                     loops.loss, loops.exponent);
}

} // namespace

/// Compares the backbone and the damping of its loops with the curve at one strain.
void backbone_is_fitted(const Case& scene, Findings& findings) {
  constexpr double strain = 1e-3;
  for (const auto& [name, soil] : named_soils(scene)) {
    const auto backbone = materials::shear_backbone(soil.column_law);
    if (!backbone || !soil.curves || !soil.curves->whole)
      continue;
    findings.add(
        "soil." + name + ".curve",
        fmt::format("soil '{}': backbone fitted to its curve, {}; at {} % strain G/G0 is {:.3f} (curve "
                    "{:.3f}) and {} {:.1f} % (curve {:.1f} %)",
                    soil.name, in_words(*backbone), 100.0 * strain,
                    backbone->secant(strain) / backbone->shear_modulus,
                    soil.curves->modulus_reduction(strain), in_words(backbone->loops),
                    100.0 * materials::loop_damping(*backbone, strain),
                    100.0 * soil.curves->damping(strain)));
  }
}

} // namespace tremolo::scene
