#include "scene/names.hpp"
#include "scene/read.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

FreeFieldModel read_model(const TableReader& table, const Case& scene) {
  using enum SourceModel;
  FreeFieldModel field;
  field.model =
      from_name(table.text("model"), std::array{wave, fe, ode, oblique, eql, mpm, recording, external});
  if (field.model == recording)
    field.file = scene.directory / table.text("file");
  if (table.given("side"))
    field.side = from_name(table.text("side"), std::array{Side::left, Side::right, Side::base});
  if (field.model == external)
    field.file = scene.directory / table.text("program");
  return field;
}

Absorber read_absorber(const TableReader& table) {
  return from_name(table.text("absorber"), std::array{Absorber::dashpots, Absorber::matched_layer});
}

LateralBoundary read_side(Document& document, const char* name, Findings& findings, const Case& scene) {
  const auto table = document.table(name);
  return {read_model(table, scene), table.optional_number("surface").value_or(scene.surface_level),
          read_layers(document, fmt::format("{}.profile", name).c_str(), findings, scene),
          read_absorber(table)};
}

} // namespace

void read_boundary(Document& document, Findings& findings, Case& scene) {
  document.table("boundary");
  scene.boundary.left = read_side(document, "boundary.left", findings, scene);
  scene.boundary.right = read_side(document, "boundary.right", findings, scene);
  const auto base = document.table("boundary.base");
  scene.boundary.base = {read_model(base, scene),
                         from_name(base.text("form"), std::array{BaseForm::total, BaseForm::incident}),
                         read_absorber(base)};
}

} // namespace tremolo::scene
