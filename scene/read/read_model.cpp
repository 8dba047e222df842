#include "scene/read/read.hpp"

namespace tremolo::scene {

namespace {

Region read_region(const TableReader& table, const std::vector<Soil>& soils, Findings& findings) {
  return {.soil = soil_index(table, soils, findings).value_or(0),
          .polygon = table.polygon("polygon"),
          .name = table.text("name"),
          .path = table.path()};
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
  read_linings(document, findings, scene);
  read_sections(document, findings, scene);
  read_props(document, findings, scene);
  read_time(document, findings, scene);
}

} // namespace tremolo::scene
