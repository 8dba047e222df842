#include "scene/plan/layers.hpp"
#include "scene/plan/step/fe_march.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <string_view>
#include <tuple>

namespace tremolo::scene {

namespace {

/// What asks a column for central differences; empty if nothing does.
std::string_view reason(const Case& scene, FeMarch march) {
  switch (march) {
  case FeMarch::one_phase:
    return {};
  case FeMarch::two_phases:
    return scene.water ? "a column with pore water" : "a column of soil that remembers its geostatic stress";
  case FeMarch::at_an_angle:
    return "a column under a wave at an angle";
  }
  return {};
}

} // namespace

void fe_is_marched_explicitly(const Case& scene, Findings& findings) {
  if (scene.fe.integrator == Integrator::central_difference || !findings.sound("fe.integrator"))
    return;
  const auto& [sides, left, right, base] = scene.boundary;
  for (const auto& [field, side] :
       {std::tuple(&left.field, &left), {&right.field, &right}, {&base.field, &left}}) {
    if (field->model != SourceModel::fe)
      continue;
    if (const auto why = reason(scene, fe_march(scene, layers(scene, *side))); !why.empty())
      return findings.add("fe.integrator",
                          fmt::format("integrator = \"{}\": {} is marched by central differences; remove "
                                      "'integrator'",
                                      name(scene.fe.integrator), why));
  }
}

} // namespace tremolo::scene
