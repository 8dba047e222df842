#include "scene/read/read.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

namespace {

Coupling read_coupling(Document& document) {
  const auto table = document.table("coupling");
  return {table.choice<ExchangeMode>("mode"), table.integer("window_steps"),
          table.number("connect_deadline_s"), table.number("step_deadline_s"),
          table.number("shutdown_deadline_s")};
}

Recording read_recording(Document& document) {
  const auto table = document.table("record");
  return {table.boolean("exchange"), table.choice<OnFullDisk>("on_full_disk")};
}

Checkpoints read_checkpoints(Document& document, Findings& findings) {
  const auto table = document.table("checkpoint");
  if (table.given("every_steps") && table.given("every_wall_s"))
    findings.add(table.path("every_wall_s"),
                 "'every_steps' and 'every_wall_s' exclude each other: remove one");
  Checkpoints checkpoints{{}, table.number("every_wall_s"), table.integer("keep")};
  if (table.given("every_steps"))
    checkpoints.every_steps = table.integer("every_steps");
  return checkpoints;
}

bool is_of_water(OutputField field) {
  return row(field).of_water;
}

Output read_output(Document& document, const Case& scene, Findings& findings) {
  const auto table = document.table("output");
  Output output{table.number("every_s"), table.number("history_every_s"), {}};
  for (const auto& field : table.texts("fields"))
    output.fields.push_back(value_named<OutputField>(field).value());
  if (!scene.water) {
    const auto of_water = std::ranges::find_if(output.fields, is_of_water);
    if (of_water != output.fields.end() && table.given("fields"))
      findings.add(table.path("fields"),
                   fmt::format("'{}' is a field of pore water, but the case has none: add [water] with its "
                               "level, or remove the field",
                               name(*of_water)));
    std::erase_if(output.fields, is_of_water);
  }
  return output;
}

SlidingMass read_sliding_mass(const TableReader& table, Findings& findings) {
  const auto outline = read_outline(table, "polygon", "circle", findings);
  if (!table.given("polygon") && !table.given("circle") && findings.sound(table.path()))
    findings.add(table.path("polygon"), "missing 'polygon' or 'circle': what encloses the sliding mass");
  return {table.text("name"), outline.value_or(Outline{})};
}

} // namespace

void read_run(Document& document, Findings& findings, Case& scene) {
  scene.coupling = read_coupling(document);
  scene.recording = read_recording(document);
  scene.checkpoints = read_checkpoints(document, findings);
  for (const auto& table : document.array("monitor"))
    scene.monitors.push_back(
        {table.text("name"), table.point("point"), structure_index(table, scene.structures, findings)});
  for (const auto& table : document.array("line"))
    scene.lines.push_back({table.text("name"), table.point("from"), table.point("to"),
                           table.optional_number("spacing").value_or(scene.mesh.size)});
  for (const auto& table : document.array("sliding_mass"))
    scene.sliding_masses.push_back(read_sliding_mass(table, findings));
  scene.output = read_output(document, scene, findings);
  scene.verify_tolerance = document.table("verify").number("tolerance");
}

} // namespace tremolo::scene
