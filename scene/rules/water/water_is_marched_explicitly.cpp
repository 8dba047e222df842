#include "scene/plan/layers.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tremolo::scene {

void water_is_marched_explicitly(const Case& scene, Findings& findings) {
  if (!scene.water || scene.fe.integrator == Integrator::central_difference ||
      !findings.sound("fe.integrator"))
    return;
  const auto& [sides, left, right, base] = scene.boundary;
  if (std::ranges::none_of(std::array{left.field.model, right.field.model, base.field.model},
                           [](SourceModel model) { return model == SourceModel::fe; }))
    return;
  findings.add("fe.integrator",
               fmt::format("integrator = \"{}\": a column with pore water is marched by central differences, "
                           "with implicit drag; remove 'integrator'",
                           name(scene.fe.integrator)));
}

} // namespace tremolo::scene
