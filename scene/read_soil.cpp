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

Soil read_soil(const NamedTable& soil, double mesh_size, Findings& findings) {
  const auto& table = soil.reader;
  const auto elastic = read_elasticity(table, findings);
  if (table.text("model") != "mohr_coulomb")
    return {soil.name, materials::LinearElastic{elastic}};
  auto law = read_mohr_coulomb(table, elastic);
  if (const auto reference = table.optional_number("reference_size"); reference && mesh_size > 0.0)
    law = materials::regularised(law, mesh_size, *reference);
  return {soil.name, law};
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
