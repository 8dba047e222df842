#include "scene/nearest.hpp"
#include "scene/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace tremolo::scene {

namespace {

materials::MohrCoulomb read_mohr_coulomb(const TableReader& table, const materials::Elasticity& elastic) {
  constexpr double degree = std::numbers::pi / 180.0;
  return {.elastic = elastic,
          .cohesion_peak = table.number("cohesion_peak"),
          .cohesion_residual = table.number("cohesion_residual"),
          .friction_peak = table.number("friction_peak_deg") * degree,
          .friction_residual = table.number("friction_residual_deg") * degree,
          .dilation_peak = table.number("dilation_peak_deg") * degree,
          .dilation_residual = table.number("dilation_residual_deg") * degree,
          .softening = table.number("softening"),
          .tension_cutoff = table.optional_number("tension_cutoff")};
}

Soil read_softening(const NamedTable& soil, const materials::Elasticity& elastic, double mesh_size) {
  auto law = read_mohr_coulomb(soil.reader, elastic);
  const auto reference = soil.reader.optional_number("reference_size");
  if (!reference || !(mesh_size > 0.0))
    return {soil.name, law, law, reference, std::nullopt};
  law = materials::regularised(law, mesh_size, *reference);
  return {soil.name, law, law, mesh_size, std::nullopt};
}

StrainCurves curves_of(const materials::Backbone& backbone) {
  return {[backbone](double strain) { return backbone.secant(strain) / backbone.shear_modulus; },
          [backbone](double strain) { return materials::masing_damping(backbone, strain); }, false};
}

/// Reports what is missing of a backbone that is not fitted.
bool complete(const TableReader& table, bool mkz, Findings& findings) {
  for (const char* key : {"reference_strain", "beta", "exponent"})
    if ((mkz || std::string_view(key) == "reference_strain") && !table.given(key)) {
      findings.add(table.path(key), fmt::format("missing '{}': without 'curve' the backbone is given", key));
      return false;
    }
  return findings.sound(table.path());
}

Soil read_hysteretic(const NamedTable& soil, const materials::Elasticity& elastic, Findings& findings) {
  const auto& table = soil.reader;
  const Soil linear{soil.name, materials::LinearElastic{elastic}, materials::LinearElastic{elastic}, {}, {}};
  const bool mkz = table.text("model") == "mkz";
  if (!complete(table, mkz, findings) || !(elastic.density > 0.0))
    return linear;
  const materials::MasingShear law{elastic, table.number("reference_strain"),
                                   mkz ? table.number("beta") : 1.0, mkz ? table.number("exponent") : 1.0};
  return {soil.name,
          materials::iwan_shear(elastic, law.reference_strain, law.beta, law.exponent),
          law,
          {},
          curves_of(law.backbone())};
}

Soil read_soil(const NamedTable& soil, double mesh_size, Findings& findings) {
  const auto elastic = read_elasticity(soil.reader, findings);
  const auto model = soil.reader.text("model");
  if (model == "mohr_coulomb")
    return read_softening(soil, elastic, mesh_size);
  if (model == "hyperbolic" || model == "mkz")
    return read_hysteretic(soil, elastic, findings);
  return {soil.name, materials::LinearElastic{elastic}, materials::LinearElastic{elastic}, {}, {}};
}

} // namespace

void read_soils(Document& document, Findings& findings, Case& scene) {
  for (const auto& soil : document.named("soil"))
    scene.soils.push_back(read_soil(soil, scene.mesh.size, findings));
}

std::optional<std::size_t> soil_index(const TableReader& table, const std::vector<Soil>& soils,
                                      Findings& findings) {
  const auto soil = table.text("soil");
  const auto found = std::ranges::find(soils, soil, &Soil::name);
  if (found != soils.end())
    return static_cast<std::size_t>(found - soils.begin());
  if (!soil.empty() && findings.sound("soil")) {
    std::vector<std::string_view> known;
    known.reserve(soils.size());
    for (const Soil& one : soils)
      known.push_back(one.name);
    findings.add(table.path("soil"),
                 fmt::format("soil '{}' is not defined, {}", soil, suggestion(soil, known)));
  }
  return std::nullopt;
}

} // namespace tremolo::scene
