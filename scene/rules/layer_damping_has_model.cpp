#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void layer_damping_has_model(const Case& scene, Findings& findings) {
  if (!std::holds_alternative<std::monostate>(scene.damping) || !findings.sound("damping"))
    return;
  for (std::size_t i = 0; i < scene.profile.size(); ++i)
    if (scene.profile[i].damping_ratio > 0.0 && findings.sound("damping.model") &&
        findings.sound("damping.frequencies"))
      findings.add(
          fmt::format("profile[{}].damping_ratio", i),
          fmt::format("'damping_ratio' = {} has no effect without a damping model; set [damping] model to "
                      "\"rayleigh\" or \"kelvin_voigt\"",
                      scene.profile[i].damping_ratio));
}

} // namespace tremolo::scene
