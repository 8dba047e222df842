#include "scene/random/random_text.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

std::string random_profile_text(const Case& scene) {
  const RandomProfile& random = *scene.random_profile;
  const auto& [sigma_ln, rho_0, delta, rho_200, h_0, b] = random.model;
  std::string text =
      fmt::format("Random profile\n"
                  "  realisation {} of seed {}: sigma_ln {:g}, rho_0 {:g}, delta {:g} m, rho_200 {:g}, h_0 "
                  "{:g} m, b {:g}\n"
                  "  {:>18} {:>8} {:>10}  soil\n",
                  random.realisation, random.seed, sigma_ln, rho_0, delta, rho_200, h_0, b, "depth (m)",
                  "factor", "Vs (m/s)");
  double top = 0.0;
  for (const Layer& layer : scene.profile) {
    const double bottom = top + layer.thickness;
    const double factor = random.factor_at(scene.surface_level - 0.5 * (top + bottom));
    text += fmt::format("  {:>18} {:>8.3f} {:>10.1f}  {}\n", fmt::format("{:g} to {:g}", top, bottom), factor,
                        layer.elastic.s_wave_speed(),
                        layer.soil ? scene.soils[*layer.soil].name : "linear elastic");
    top = bottom;
  }
  return text;
}

} // namespace tremolo::scene
