#include "scene/read/read.hpp"
#include "scene/read/soil/read_water.hpp"

#include <fmt/format.h>

#include <string_view>

namespace tremolo::scene {

namespace {

FreeFieldModel read_model(const TableReader& table, const Case& scene) {
  using enum SourceModel;
  FreeFieldModel field;
  field.model = table.choice<SourceModel>("model");
  if (field.model == recording)
    field.file = scene.directory / table.text("file");
  if (table.given("side"))
    field.side = table.choice<Side>("side");
  if (field.model == external)
    field.file = scene.directory / table.text("program");
  return field;
}

Absorber read_absorber(const TableReader& table) {
  return table.choice<Absorber>("absorber");
}

SpringKeys read_springs(const TableReader& table) {
  SpringKeys keys;
  if (table.given("spring")) {
    const std::vector<double> stiffness = table.numbers("spring");
    keys.given_up = stiffness.empty();
    if (!keys.given_up)
      keys.stiffness = {stiffness[0], stiffness[1]};
  }
  if (table.given("spring_centre"))
    keys.centre = table.point("spring_centre");
  return keys;
}

/// The side that a table describes, as far as the ground goes.
LateralBoundary ground_of_side(const char* name, double surface, const Case& scene) {
  LateralBoundary side;
  side.surface = surface;
  if (scene.water)
    side.water_level =
        scene.water->beside(std::string_view(name) == "boundary.right" ? Side::right : Side::left, surface);
  return side;
}

LateralBoundary read_side(Document& document, const char* name, Findings& findings, const Case& scene) {
  if (!document.has(name))
    findings.add(name,
                 fmt::format("missing table [{}]: the free field of this side, unless [boundary] sides = "
                             "\"periodic\" or \"container\"",
                             name));
  const auto table = document.table(name);
  const double surface = table.optional_number("surface").value_or(scene.surface_level);
  LateralBoundary side = ground_of_side(name, surface, scene);
  auto own = read_layers(document, fmt::format("{}.profile", name).c_str(), findings, scene);
  // The water table cuts the layers of [[profile]] elsewhere under another surface, and another table does.
  if (scene.water && own.empty() &&
      (surface != scene.surface_level || side.water_level != scene.water->beside(Side::left, surface)))
    own = scene.profile;
  side.field = read_model(table, scene);
  side.own_profile = watered(own, side, scene);
  side.absorber = read_absorber(table);
  side.springs = read_springs(table);
  return side;
}

/// Periodic sides and walls have no free field, only the level of its surface.
LateralBoundary read_side_without_field(Document& document, const char* name, Findings& findings,
                                        const Case& scene) {
  if (document.has(name)) {
    document.table(name);
    findings.add(name,
                 fmt::format("[{}] is the free field of a side, but sides = \"{}\" have none; remove it, "
                             "or choose sides = \"free_field\"",
                             name, scene::name(scene.boundary.sides)));
  }
  return ground_of_side(name, scene.surface_level, scene);
}

/// Between equal grounds a blend of both total fields is the one total field.
BaseForm read_form(const TableReader& table, const Boundary& boundary) {
  const auto form = table.choice<BaseForm>("form");
  return form == BaseForm::blended && boundary.has_equal_sides() ? BaseForm::total : form;
}

} // namespace

void read_boundary(Document& document, Findings& findings, Case& scene) {
  scene.boundary.sides = document.table("boundary").choice<Sides>("sides");
  const auto read = scene.boundary.has_lateral_fields() ? read_side : read_side_without_field;
  scene.boundary.left = read(document, "boundary.left", findings, scene);
  scene.boundary.right = read(document, "boundary.right", findings, scene);
  const auto base = document.table("boundary.base");
  scene.boundary.base = {read_model(base, scene), read_form(base, scene.boundary), read_absorber(base),
                         read_springs(base)};
}

} // namespace tremolo::scene
