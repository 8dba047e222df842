#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <numbers>

namespace tremolo::scene {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

struct Bounded {
  const char* key;
  double value;
  const char* bound_key;
  double bound;
};

} // namespace

void strength_is_ordered(const Case& scene, Findings& findings) {
  for (const Soil& soil : scene.soils) {
    const auto* law = std::get_if<materials::MohrCoulomb>(&soil.law);
    if (law == nullptr)
      continue;
    const std::string path = "soil." + soil.name + ".";
    for (const auto& [key, value, bound_key, bound] :
         {Bounded{"cohesion_residual", law->cohesion_residual, "cohesion_peak", law->cohesion_peak},
          Bounded{"friction_residual_deg", law->friction_residual * degrees, "friction_peak_deg",
                  law->friction_peak * degrees},
          Bounded{"dilation_residual_deg", law->dilation_residual * degrees, "dilation_peak_deg",
                  law->dilation_peak * degrees},
          Bounded{"dilation_peak_deg", law->dilation_peak * degrees, "friction_peak_deg",
                  law->friction_peak * degrees},
          Bounded{"dilation_residual_deg", law->dilation_residual * degrees, "friction_residual_deg",
                  law->friction_residual * degrees}})
      if (value > bound && findings.sound(path + key) && findings.sound(path + bound_key))
        findings.add(path + key,
                     fmt::format("'{}' = {:g} is above '{}' = {:g}", key, value, bound_key, bound));
    if (law->cohesion_residual == 0.0 && law->friction_residual == 0.0 &&
        findings.sound(path + "cohesion_residual") && findings.sound(path + "friction_residual_deg"))
      findings.add(
          path + "friction_residual_deg",
          "'friction_residual_deg' and 'cohesion_residual' are both 0: the soil would have no strength");
  }
}

} // namespace tremolo::scene
