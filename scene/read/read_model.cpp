#include "scene/read/read.hpp"

namespace tremolo::scene {

namespace {

Region read_region(const TableReader& table, const std::vector<Soil>& soils, Findings& findings) {
  return {soil_index(table, soils, findings).value_or(0), table.polygon("polygon")};
}

Box read_box(const TableReader& table) {
  const auto box = table.numbers("box");
  return box.empty() ? Box{} : Box{box[0], box[1], box[2], box[3]};
}

} // namespace

void read_time(Document& document, Findings& findings, Case& scene) {
  const auto table = document.table("time");
  if (table.given("dt") && table.given("fraction"))
    findings.add(table.path("dt"), "'dt' and 'fraction' exclude each other: remove one");
  scene.time = {table.number("fraction"), table.optional_number("dt"), table.choice<Transfer>("transfer"),
                table.choice<StepOrder>("order"), table.boolean("subcycle")};
}

void read_stages(Document& document, Findings& findings, Case& scene) {
  bool shaken = false;
  bool legible = true;
  for (const auto& table : document.array("stage")) {
    const auto kind = table.text("kind");
    legible = legible && !kind.empty();
    if (kind == "gravity") {
      if (scene.gravity || shaken || scene.rest)
        findings.add(table.path("kind"), scene.gravity
                                             ? "a second gravity stage: there can be at most one"
                                             : "the gravity stage must come before the shaking stage");
      scene.gravity =
          GravityStage{table.number("acceleration"), table.number("residual"), table.number("max_time_s")};
    }
    if (kind == "shaking") {
      if (shaken || scene.rest)
        findings.add(table.path("kind"), shaken ? "a second shaking stage: there must be exactly one"
                                                : "the shaking stage must come before the rest");
      shaken = true;
      scene.shaking.duration = table.number("duration_s");
    }
    if (kind == "rest") {
      if (scene.rest)
        findings.add(table.path("kind"), "a second rest: there can be at most one");
      scene.rest = RestStage{.duration = table.number("duration_s"),
                             .time_factor = table.number("time_factor"),
                             .until_ratio = table.optional_number("until_ratio"),
                             .every = table.optional_number("every_s"),
                             .growth = table.number("growth"),
                             .history_every = table.optional_number("history_every_s")};
    }
  }
  if (!shaken && legible && findings.sound("stage"))
    findings.add("stage", "missing [[stage]] of kind = \"shaking\": how long the motion acts");
}

void read_mesh(Document& document, Case& scene) {
  const auto table = document.table("mesh");
  scene.mesh = {table.number("size"),
                read_box(table),
                table.integer("particles_per_cell"),
                table.integer("layer_cells"),
                {},
                table.choice<ParticleBoxes>("particle_boxes"),
                table.choice<Dilatation>("dilatation"),
                table.choice<Dispersion>("dispersion"),
                table.choice<ContactNormals>("contact_normals")};
  for (const auto& refine : document.array("refine"))
    scene.mesh.refine.push_back({read_box(refine), refine.integer("level")});
}

void read_model(Document& document, Findings& findings, Case& scene) {
  for (const auto& table : document.array("region"))
    scene.regions.push_back(read_region(table, scene.soils, findings));
  read_structures(document, findings, scene);
  read_time(document, findings, scene);
  read_stages(document, findings, scene);
}

} // namespace tremolo::scene
