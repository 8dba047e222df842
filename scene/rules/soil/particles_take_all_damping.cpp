#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tremolo::scene {

void particles_take_all_damping(const Case& scene, Findings& findings) {
  if (scene.damping.model != DampingModel::rayleigh)
    return;
  const auto& [sides, left, right, base] = scene.boundary;
  const bool domain = domain_is_damped(scene);
  const bool column = std::ranges::any_of(std::array{left, right}, [&](const LateralBoundary& side) {
    return side.field.model == SourceModel::mpm && damped(layers(scene, side));
  });
  if (!domain && !column)
    return;
  const auto [f1, f2] = scene.damping.frequencies;
  findings.add(
      "damping.model",
      fmt::format("{} the part of Rayleigh's damping that is proportional to stiffness alone: {:.3g} of "
                  "its ratio at {} Hz and {:.3g} at {} Hz; model = \"kelvin_voigt\" is the same in "
                  "domain and columns",
                  domain ? "the domain has" : "the cells of model = \"mpm\" have", f1 / (f1 + f2), f1,
                  f2 / (f1 + f2), f2));
}

} // namespace tremolo::scene
