#include "scene/random/random_profile.hpp"
#include "scene/read/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace tremolo::scene {

namespace {

/// More would be thinner than any measurement resolves.
constexpr double most_random_layers = 500.0;

/// Takes the parameters that are given, and the others from the class of the site.
ToroModel read_toro_model(TableReader& table, Findings& findings) {
  const bool has_class = table.given("site_class");
  ToroModel model = has_class ? toro_model(table.choice<ToroClass>("site_class")) : ToroModel{};
  const std::array parameters = {std::pair("sigma_ln", &model.sigma_ln), std::pair("rho_0", &model.rho_0),
                                 std::pair("delta", &model.delta),       std::pair("rho_200", &model.rho_200),
                                 std::pair("h_0", &model.h_0),           std::pair("b", &model.b)};
  if (!has_class &&
      std::ranges::none_of(parameters, [&](const auto& one) { return table.given(one.first); })) {
    findings.add(table.path("site_class"), "missing 'site_class', or each of 'sigma_ln', 'rho_0', 'delta', "
                                           "'rho_200', 'h_0' and 'b': how Vs varies");
    return model;
  }
  for (const auto& [key, value] : parameters) {
    if (table.given(key))
      *value = table.number(key);
    else if (has_class)
      table.settle(key, *value, fmt::format("site_class {}", table.text("site_class")));
    else
      findings.add(table.path(key),
                   fmt::format("missing '{}': without 'site_class' each parameter is given", key));
  }
  return model;
}

/// Refuses what cannot be varied.
void check_layers(const TableReader& table, Findings& findings, const Case& scene) {
  if (scene.profile.empty() && findings.sound("profile"))
    findings.add(table.path(), "[random_profile] varies Vs of the layers of [[profile]], which the case does "
                               "not have: add them, or remove the table");
  for (const Layer& layer : scene.profile)
    if (layer.soil && materials::traits(scene.soils[*layer.soil].law).follows_pressure)
      findings.add(table.path(),
                   fmt::format("soil '{}' has a stiffness that follows the effective stress, and the rate of "
                               "its pore pressure is calibrated with it: Vs alone cannot vary; take a soil "
                               "with another model, or remove the table",
                               scene.soils[*layer.soil].name));
  if (!findings.sound(table.path("layer_thickness")))
    return;
  double parts = 0.0;
  for (const Layer& layer : scene.profile)
    parts += std::ceil(layer.thickness / table.number("layer_thickness"));
  if (parts > most_random_layers)
    findings.add(table.path("layer_thickness"),
                 fmt::format("'layer_thickness' = {} m cuts [[profile]] into {:.0f} layers, allowed: at most "
                             "{:.0f}",
                             table.number("layer_thickness"), parts, most_random_layers));
}

} // namespace

void read_random_profile(Document& document, Findings& findings, Case& scene) {
  if (!document.has("random_profile"))
    return;
  TableReader table = document.table("random_profile");
  RandomProfile profile;
  profile.model = read_toro_model(table, findings);
  profile.layer_thickness = table.number("layer_thickness");
  profile.seed = static_cast<std::uint32_t>(table.number("seed"));
  profile.realisation = static_cast<std::uint32_t>(table.number("realisation"));
  check_layers(table, findings, scene);
  if (findings.failed())
    return;
  std::vector<double> thicknesses;
  for (const Layer& layer : scene.profile)
    thicknesses.push_back(layer.thickness);
  realise(profile, scene.surface_level, thicknesses);
  scene.random_profile = std::move(profile);
}

} // namespace tremolo::scene
