#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tremolo::scene {

void particles_take_all_damping(const Case& scene, Findings& findings) {
  if (scene.damping.model != DampingModel::rayleigh || mass_damping(scene, 1.0) > 0.0)
    return;
  const auto& [sides, left, right, base] = scene.boundary;
  const bool domain = domain_is_damped(scene);
  const bool column = std::ranges::any_of(std::array{left, right}, [&](const LateralBoundary& side) {
    return traits(side.field.model).of_domain_cells && damped(layers(scene, side));
  });
  if (!domain && !column)
    return;
  const auto [f1, f2] = scene.damping.frequencies;
  findings.add(
      "damping.model",
      fmt::format("{} the part of Rayleigh's damping that is proportional to stiffness alone: {:.3g} of "
                  "its ratio at {} Hz and {:.3g} at {} Hz, since the other part is relative to the motion of "
                  "rock, which a wave beyond its critical angle does not give; model = \"kelvin_voigt\" is "
                  "the same in domain and columns",
                  domain ? "the domain has" : "the cells of model = \"mpm\" have", f1 / (f1 + f2), f1,
                  f2 / (f1 + f2), f2));
}

} // namespace tremolo::scene
