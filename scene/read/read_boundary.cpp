#include "scene/keys/names.hpp"
#include "scene/read/read.hpp"

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
  if (!document.has(name))
    findings.add(name,
                 fmt::format("missing table [{}]: the free field of this side, unless [boundary] sides = "
                             "\"periodic\"",
                             name));
  const auto table = document.table(name);
  return {read_model(table, scene), table.optional_number("surface").value_or(scene.surface_level),
          read_layers(document, fmt::format("{}.profile", name).c_str(), findings, scene),
          read_absorber(table)};
}

/// Where the model repeats itself there is no free field, only the level of its surface.
LateralBoundary read_periodic_side(Document& document, const char* name, Findings& findings,
                                   const Case& scene) {
  if (document.has(name)) {
    document.table(name);
    findings.add(name,
                 fmt::format("[{}] is the free field of a side, but sides = \"{}\" have none; remove it, "
                             "or choose sides = \"free_field\"",
                             name, scene::name(scene.boundary.sides)));
  }
  LateralBoundary side;
  side.surface = scene.surface_level;
  return side;
}

/// Between equal grounds a blend of both total fields is the one total field.
BaseForm read_form(const TableReader& table, const LateralBoundary& left, const LateralBoundary& right) {
  const auto form =
      from_name(table.text("form"), std::array{BaseForm::total, BaseForm::incident, BaseForm::blended});
  const bool equal = left.surface == right.surface && left.own_profile.empty() && right.own_profile.empty();
  return form == BaseForm::blended && equal ? BaseForm::total : form;
}

} // namespace

void read_boundary(Document& document, Findings& findings, Case& scene) {
  scene.boundary.sides = from_name(document.table("boundary").text("sides"),
                                   std::array{Sides::free_field, Sides::periodic, Sides::periodic_springs});
  const auto read = scene.boundary.periodic() ? read_periodic_side : read_side;
  scene.boundary.left = read(document, "boundary.left", findings, scene);
  scene.boundary.right = read(document, "boundary.right", findings, scene);
  const auto base = document.table("boundary.base");
  scene.boundary.base = {read_model(base, scene), read_form(base, scene.boundary.left, scene.boundary.right),
                         read_absorber(base)};
}

} // namespace tremolo::scene
