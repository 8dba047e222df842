#include "scene/layers.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace tremolo::scene {

namespace {

/// Why a model cannot compute with these layers; empty if it can.
std::string refused(const Case& scene, SourceModel model, const std::vector<Layer>& layers) {
  if (model == SourceModel::oblique &&
      std::ranges::any_of(layers, [](const Layer& layer) { return layer.damping > 0.0; }))
    return "model = \"oblique\" takes layers without viscous damping, with which waves of one slowness have "
           "no well-posed column; use model = \"wave\", or hysteretic soil";
  for (const Layer& layer : layers)
    if ((model == SourceModel::ode || model == SourceModel::oblique) && layer.soil &&
        std::holds_alternative<materials::MohrCoulomb>(scene.soils[*layer.soil].law))
      return fmt::format(
          "model = \"{}\" takes linear and hysteretic soil, but soil '{}' is mohr_coulomb; use model = "
          "\"fe\"",
          name(model), scene.soils[*layer.soil].name);
  return {};
}

} // namespace

void soils_suit_models(const Case& scene, Findings& findings) {
  const auto check = [&](SourceModel model, const std::vector<Layer>& layers, const std::string& path) {
    if (const auto why = refused(scene, model, layers); !why.empty() && findings.sound(path))
      findings.add(path, why);
  };
  const auto& [left, right, base] = scene.boundary;
  check(left.field.model, layers(scene, left), "boundary.left.model");
  check(right.field.model, layers(scene, right), "boundary.right.model");
  check(base.field.model, layers(scene, left), "boundary.base.model");
}

} // namespace tremolo::scene
