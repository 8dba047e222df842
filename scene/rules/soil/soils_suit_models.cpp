#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace tremolo::scene {

namespace {

/// Whether shear stress follows from shear strain alone.
bool in_one_shear(const materials::Law& law) {
  return materials::traits(law).response == materials::Response::elastic || materials::shear_backbone(law);
}

/// Why a model cannot compute with these layers; empty if it can.
std::string refused(const Case& scene, SourceModel model, const std::vector<Layer>& layers) {
  const bool damped = std::ranges::any_of(layers, [](const Layer& layer) { return layer.damping > 0.0; });
  if (model == SourceModel::oblique && damped)
    return "model = \"oblique\" takes layers without viscous damping, with which waves of one slowness have "
           "no well-posed column; use model = \"wave\", or hysteretic soil";
  for (const Layer& layer : layers) {
    if (!layer.soil)
      continue;
    const Soil& soil = scene.soils[*layer.soil];
    const bool column =
        model == SourceModel::fe || model == SourceModel::ode || model == SourceModel::oblique;
    const bool two_phase = model == SourceModel::fe && scene.water;
    if (column && !two_phase && materials::traits(soil.law).remembers_initial_stress)
      return fmt::format(
          "model = \"{}\" gives its soil no memory of the geostatic stress, with which {} "
          "(soil '{}') begins; use "
          "model = \"mpm\", or \"fe\" under a water table, or \"wave\", which takes its layers as linear "
          "elastic",
          name(model), materials::name(soil.law), soil.name);
    if ((model == SourceModel::ode || model == SourceModel::oblique) && !in_one_shear(soil.column_law))
      return fmt::format("model = \"{}\" takes linear and hysteretic soil, but soil '{}' is {}; use model = "
                         "\"fe\"",
                         name(model), soil.name, materials::name(soil.law));
  }
  return {};
}

} // namespace

void soils_suit_models(const Case& scene, Findings& findings) {
  const auto check = [&](SourceModel model, const std::vector<Layer>& layers, const std::string& path) {
    if (const auto why = refused(scene, model, layers); !why.empty() && findings.sound(path))
      findings.add(path, why);
  };
  const auto& [sides, left, right, base] = scene.boundary;
  if (scene.boundary.has_lateral_fields()) {
    check(left.field.model, layers(scene, left), "boundary.left.model");
    check(right.field.model, layers(scene, right), "boundary.right.model");
  }
  check(base.field.model, layers(scene, left), "boundary.base.model");
}

} // namespace tremolo::scene
