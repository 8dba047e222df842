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

/// Direction of incidence of a wave, and the point at which its motion is given.
void read_way(const TableReader& table, MotionInput& input) {
  input.angle_deg = table.number("angle_deg");
  if (table.given("reference"))
    input.reference = table.point("reference");
}

void require_key(const TableReader& table, const char* key, const char* what, const Case& scene,
                 Findings& findings) {
  if (!table.given(key) && scene.boundary.takes_waves() && findings.sound(table.path()))
    findings.add(table.path(key), fmt::format("missing '{}': {}", key, what));
}

constexpr const char* angle_is = "its angle of incidence from the vertical, degrees";

/// [motion.vertical], beside the motion that has been read.
void read_vertical(const TableReader& table, Case& scene, Findings& findings) {
  if (!scene.vertical)
    scene.vertical.emplace();
  MotionInput& input = *scene.vertical;
  input.path = table.path();
  input.wave = Wave::p;
  input.kind = scene.motion.kind;
  input.reference = scene.motion.reference;
  input.shakings.front().path = table.path();
  require_key(table, "angle_deg", angle_is, scene, findings);
  read_way(table, input);
  if (auto source = read_motion_source(table, scene, findings))
    input.shakings.front().source = *std::move(source);
  if (scene.motion.wave != Wave::sv && findings.sound("motion.wave"))
    findings.add(table.path(),
                 "[motion.vertical] is a P wave that comes up beside an SV wave, but [motion] has "
                 "wave = \"P\": make the vertical motion [motion] alone, or the horizontal one "
                 "[motion] with wave = \"SV\"");
}

/// Every record is of the kind of [motion].
void set_kind(const TableReader& table, MotionInput& input, Findings& findings) {
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
  require_key(table, "angle_deg", angle_is, scene, findings);
  require_key(table, "reference", "where, [x, y], the incident wave has this motion", scene, findings);
  input.wave = table.choice<Wave>("wave");
  read_way(table, input);
  if (auto source = read_motion_source(table, scene, findings))
    input.shakings.front().source = *std::move(source);
  set_kind(table, input, findings);
  if (const auto vertical = table.table("vertical"))
    read_vertical(*vertical, scene, findings);
  else if (scene.vertical)
    findings.add(scene.vertical->shakings.back().path,
                 "[stage.motion.vertical] needs [motion.vertical], which says from where its wave comes");
  if (scene.vertical)
    set_kind(table, *scene.vertical, findings);
}

} // namespace tremolo::scene
