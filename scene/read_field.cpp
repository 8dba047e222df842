#include "scene/names.hpp"
#include "scene/read.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

RickerPulse read_pulse(Document& document) {
  const auto table = document.table("motion.pulse");
  return {table.number("frequency"), table.number("time"), table.number("velocity")};
}

void read_motion(Document& document, Findings& findings, Case& scene) {
  const auto table = document.table("motion");
  scene.motion.wave = from_name(table.text("wave"), std::array{Wave::sv, Wave::p});
  scene.motion.angle_deg = table.number("angle_deg");
  scene.motion.reference = table.point("reference");

  const bool pulse = document.has("motion.pulse");
  const bool file = table.given("file");
  if (pulse == file) {
    if (findings.sound("motion"))
      findings.add("motion", file ? "'pulse' and 'file' exclude each other: remove one"
                                  : "missing 'pulse' or 'file': what the incident wave is");
    return;
  }
  if (pulse) {
    scene.motion.source = read_pulse(document);
    for (const char* key : {"quantity", "scale"})
      if (table.given(key))
        findings.add(table.path(key), fmt::format("'{}' does not apply to 'pulse', only to 'file'", key));
    return;
  }
  scene.motion.source =
      MotionFile{scene.directory / table.text("file"),
                 from_name(table.text("quantity"), std::array{Quantity::acceleration, Quantity::velocity}),
                 table.number("scale")};
}

void read_damping(Document& document, Case& scene) {
  const auto table = document.table("damping");
  scene.damping_ratio = table.number("ratio");
  const auto frequencies = table.numbers("frequencies");
  if (table.text("model") == "rayleigh" && frequencies.size() == 2)
    scene.damping = RayleighDamping{frequencies[0], frequencies[1]};
  if (table.text("model") == "kelvin_voigt")
    scene.damping = KelvinVoigtDamping{table.number("reference_frequency")};
}

SourceModel read_model(const TableReader& table) {
  return from_name(table.text("model"), std::array{SourceModel::wave, SourceModel::column});
}

LateralBoundary read_side(Document& document, const char* name, double surface_level) {
  const auto table = document.table(name);
  return {read_model(table), table.optional_number("surface").value_or(surface_level)};
}

} // namespace

void read_free_field(Document& document, Findings& findings, Case& scene) {
  read_motion(document, findings, scene);
  scene.surface_level = document.table("surface").number("level");
  scene.halfspace = read_elasticity(document.table("halfspace"), findings);

  read_damping(document, scene);
  for (const auto& table : document.array("profile"))
    scene.profile.push_back({table.number("thickness"), read_elasticity(table, findings),
                             table.optional_number("damping_ratio").value_or(scene.damping_ratio)});
}

void read_field(Document& document, Findings& findings, Case& scene) {
  read_free_field(document, findings, scene);

  const auto column = document.table("column");
  scene.column.integrator =
      from_name(column.text("integrator"), std::array{Integrator::central_difference, Integrator::newmark});
  scene.column.element_size = column.number("element_size");
  scene.column.dt = column.optional_number("dt");

  document.table("boundary");
  scene.boundary.left = read_side(document, "boundary.left", scene.surface_level);
  scene.boundary.right = read_side(document, "boundary.right", scene.surface_level);
  const auto base = document.table("boundary.base");
  scene.boundary.base = {read_model(base),
                         from_name(base.text("form"), std::array{BaseForm::total, BaseForm::incident})};
}

} // namespace tremolo::scene
