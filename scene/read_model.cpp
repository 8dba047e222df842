#include "scene/names.hpp"
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

Region read_region(const TableReader& table, const std::vector<Soil>& soils, Findings& findings) {
  const auto soil = table.text("soil");
  const auto found = std::ranges::find(soils, soil, &Soil::name);
  if (found == soils.end() && !soil.empty() && findings.sound("soil")) {
    std::vector<std::string_view> known;
    known.reserve(soils.size());
    for (const Soil& one : soils)
      known.push_back(one.name);
    findings.add(table.path("soil"),
                 fmt::format("soil '{}' is not defined, {}", soil, suggestion(soil, known)));
  }
  return {static_cast<std::size_t>(found == soils.end() ? 0 : found - soils.begin()),
          table.polygon("polygon")};
}

Mesh read_mesh(Document& document) {
  const auto table = document.table("mesh");
  const auto box = table.numbers("box");
  return {table.number("size"), box.empty() ? Box{} : Box{box[0], box[1], box[2], box[3]},
          table.integer("particles_per_cell")};
}

TimeStepping read_time(Document& document, Findings& findings) {
  const auto table = document.table("time");
  if (table.given("dt") && table.given("fraction"))
    findings.add(table.path("dt"), "'dt' and 'fraction' exclude each other: remove one");
  return {table.number("fraction"), table.optional_number("dt"),
          from_name(table.text("transfer"), std::array{Transfer::apic, Transfer::flip, Transfer::pic_blend}),
          table.number("blend_time"),
          from_name(table.text("order"), std::array{StepOrder::usl, StepOrder::usf, StepOrder::musl})};
}

void read_stages(Document& document, Findings& findings, Case& scene) {
  bool shaken = false;
  bool legible = true;
  for (const auto& table : document.array("stage")) {
    const auto kind = table.text("kind");
    legible = legible && !kind.empty();
    if (kind == "gravity") {
      if (scene.gravity || shaken)
        findings.add(table.path("kind"), scene.gravity
                                             ? "a second gravity stage: there can be at most one"
                                             : "the gravity stage must come before the shaking stage");
      scene.gravity =
          GravityStage{table.number("acceleration"), table.number("residual"), table.number("max_time_s")};
    }
    if (kind == "shaking") {
      if (shaken)
        findings.add(table.path("kind"), "a second shaking stage: there must be exactly one");
      shaken = true;
      scene.shaking.duration = table.number("duration_s");
    }
  }
  if (!shaken && legible && findings.sound("stage"))
    findings.add("stage", "missing [[stage]] of kind = \"shaking\": how long the motion acts");
}

} // namespace

void read_model(Document& document, Findings& findings, Case& scene) {
  scene.mesh = read_mesh(document);
  if (scene.column.element_size == 0.0)
    scene.column.element_size = scene.mesh.size;
  for (const auto& soil : document.named("soil"))
    scene.soils.push_back(read_soil(soil, scene.mesh.size, findings));
  for (const auto& table : document.array("region"))
    scene.regions.push_back(read_region(table, scene.soils, findings));
  scene.time = read_time(document, findings);
  read_stages(document, findings, scene);
}

} // namespace tremolo::scene
