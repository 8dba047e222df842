#include "scene/read/read.hpp"

#include <fmt/format.h>

#include <utility>

namespace tremolo::scene {

namespace {

void refuse_keys_of_record(const TableReader& table, Findings& findings) {
  for (const char* key : {"quantity", "unit", "scale", "component", "column"})
    if (table.given(key))
      findings.add(table.path(key), fmt::format("'{}' does not apply to 'pulse', only to 'file'", key));
}

} // namespace

std::optional<MotionSource> read_motion_source(const TableReader& table, const Case& scene,
                                               Findings& findings) {
  const auto pulse = table.table("pulse");
  const bool file = table.given("file");
  if (pulse.has_value() == file) {
    if (findings.sound(table.path()))
      findings.add(table.path(), file ? "'pulse' and 'file' exclude each other: remove one"
                                      : "missing 'pulse' or 'file': what the incident wave is");
    return std::nullopt;
  }
  if (pulse) {
    refuse_keys_of_record(table, findings);
    return RickerPulse{pulse->number("frequency"), pulse->number("time"), pulse->number("velocity")};
  }
  MotionFile record;
  record.path = scene.directory / table.text("file");
  record.as.quantity = motion::quantity_named(table.text("quantity"));
  record.as.unit = motion::unit_named(table.text("unit"));
  record.as.component = table.text("component");
  record.as.column = table.text("column");
  record.scale = table.number("scale");
  return record;
}

void read_motion(Document& document, Findings& findings, Case& scene) {
  const auto table = document.table("motion");
  MotionInput& input = scene.motion;
  if (table.given("kind"))
    input.kind = table.choice<motion::MotionKind>("kind");
  for (const auto& [key, what] : {std::pair("angle_deg", "its angle of incidence from the vertical, degrees"),
                                  std::pair("reference", "where, [x, y], the incident wave has this motion")})
    if (!table.given(key) && !scene.boundary.has_shaking_table() && findings.sound("motion"))
      findings.add(table.path(key), fmt::format("missing '{}': {}", key, what));
  input.wave = table.choice<Wave>("wave");
  input.angle_deg = table.number("angle_deg");
  input.reference = table.point("reference");
  if (auto source = read_motion_source(table, scene, findings))
    input.shakings.front().source = *std::move(source);
  for (ShakingMotion& shaking : input.shakings)
    if (auto* record = std::get_if<MotionFile>(&shaking.source)) {
      record->as.kind = input.kind;
      if (!table.given("kind") && findings.sound(table.path()))
        findings.add(table.path("kind"),
                     "missing 'kind', which a 'file' needs: whose motion the record is, \"outcrop\" of a "
                     "station on rock (twice the incident wave), \"within\" of a sensor at depth, "
                     "\"incident\" of the upgoing wave alone");
    }
}

} // namespace tremolo::scene
