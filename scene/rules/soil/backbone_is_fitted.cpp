#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

/// Compares the backbone and the damping of the Masing rules with the curve at one strain.
void backbone_is_fitted(const Case& scene, Findings& findings) {
  constexpr double strain = 1e-3;
  for (const Soil& soil : scene.soils) {
    const auto backbone = materials::shear_backbone(soil.column_law);
    if (!backbone || !soil.curves || !soil.curves->whole)
      continue;
    findings.add(
        "soil." + soil.name + ".curve",
        fmt::format(
            "soil '{}': backbone fitted to its curve, reference_strain = {:.4g}, beta = {:.4g}, exponent = "
            "{:.4g}; at {} % strain G/G0 is {:.3f} (curve {:.3f}) and the damping of the Masing rules {:.1f} "
            "% "
            "(curve {:.1f} %)",
            soil.name, backbone->reference_strain, backbone->beta, backbone->exponent, 100.0 * strain,
            backbone->secant(strain) / backbone->shear_modulus, soil.curves->modulus_reduction(strain),
            100.0 * materials::masing_damping(*backbone, strain), 100.0 * soil.curves->damping(strain)));
  }
}

} // namespace tremolo::scene
