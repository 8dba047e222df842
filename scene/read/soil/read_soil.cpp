#include "scene/read/soil/read_soil.hpp"

#include "base/text/unit_text.hpp"
#include "scene/keys/soil/keys_law.hpp"
#include "scene/read/read.hpp"
#include "scene/read/soil/read_water.hpp"
#include "scene/soils/soil_library.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

namespace tremolo::scene {

namespace {

/// The model of a soil of the library is part of it.
bool keeps_model(const TableReader& table, Findings& findings) {
  const LibrarySoil* soil = library_soil(table.text(library_key));
  const auto own = soil != nullptr ? (*soil->keys)["model"].value<std::string>() : std::nullopt;
  if (!own || *own == table.text("model") || !findings.sound(table.path("model")))
    return true;
  findings.add(table.path("model"),
               fmt::format("'{}' of the library is \"{}\", which a case cannot change: remove 'model'",
                           soil->name, *own));
  return false;
}

} // namespace

void need(const TableReader& table, std::string_view key, Findings& findings) {
  if (!table.given(key) && findings.sound(table.path(key)) && findings.sound(table.path(library_key)))
    findings.add(table.path(key),
                 fmt::format("missing '{}': model = \"{}\" needs it", key, table.text("model")));
}

bool sound_numbers(const TableReader& table, SoilModel model, Findings& findings) {
  bool sound = true;
  for (const materials::Parameter& parameter : parameters_of(model)) {
    if (parameter.needed())
      need(table, parameter.name, findings);
    if (const auto value = table.optional_number(parameter.name); value && !parameter.range.contains(*value))
      findings.add(table.path(parameter.name),
                   fmt::format("'{}' = {} is out of range, must be {} with model = \"{}\"", parameter.name,
                               *value, with_unit(parameter.range.text(), parameter.unit), name(model)));
    sound = sound && findings.sound(table.path(parameter.name));
  }
  return sound;
}

void read_fields(materials::Law& law, const TableReader& table) {
  for (const auto& [text, value] : materials::fields(law))
    *value = table.number(text.name) * materials::in_law(text);
}

Soil placeholder(const std::string& name) {
  return {name, materials::LinearElastic{}, materials::LinearElastic{}, {}, {}};
}

Soil read_soil(const NamedTable& soil, const std::filesystem::path& directory, double mesh_size,
               Findings& findings) {
  const auto model = value_named<SoilModel>(soil.reader.text("model"));
  if (!keeps_model(soil.reader, findings) || !model)
    return placeholder(soil.name);
  using enum SoilModel;
  switch (*model) {
  case mohr_coulomb:
    return read_mohr_coulomb(soil, mesh_size, findings);
  case hyperbolic:
  case mkz:
  case gqh:
    return read_hysteretic(soil, directory, findings);
  case pm4sand:
  case pdmy03:
    return read_sand(soil, directory, findings);
  default:
    return read_plastic(soil, directory, findings);
  }
}

Soil read_soil_of_case(NamedTable& table, const Case& scene, Findings& findings) {
  const auto pores = read_pores(table.reader, scene.water, findings);
  Soil soil = read_soil(table, scene.directory, scene.mesh.size, findings);
  soil.pores = pores;
  soil.law_void_ratio = void_ratio_of_law(table.reader);
  if (const auto at_rest = table.reader.optional_number("rest_coefficient"))
    for (materials::Law* law : {&soil.law, &soil.column_law})
      *law = materials::with_rest_coefficient(std::move(*law), *at_rest);
  soil.damping = table.reader.optional_number("damping").value_or(scene.damping.ratio);
  return soil;
}

namespace {

/// A soil that will be sliced. Its profiles have no common place yet, so only its slices can be judged as
/// soils; the ground above them needs its weight.
Soil before_slicing(NamedTable& table, const Case& scene, const Findings& findings) {
  Findings unheard = findings;
  Soil soil = read_soil_of_case(table, scene, unheard);
  if (!(materials::elasticity(soil.law).density > 0.0))
    soil.law = materials::LinearElastic{{table.reader.number("density"), 0.0, 0.0}};
  return soil;
}

} // namespace

void read_soils(Document& document, Findings& findings, Case& scene) {
  for (auto& soil : document.named("soil"))
    scene.soils.push_back(soil.reader.varies_over_depth() ? before_slicing(soil, scene, findings)
                                                          : read_soil_of_case(soil, scene, findings));
}

std::optional<std::size_t> soil_index(const TableReader& table, const std::vector<Soil>& soils,
                                      Findings& findings) {
  const auto soil = table.text("soil");
  const auto found = std::ranges::find(soils, soil, &Soil::name);
  if (found != soils.end())
    return static_cast<std::size_t>(found - soils.begin());
  if (!soil.empty() && findings.sound("soil")) {
    std::vector<std::string_view> known;
    known.reserve(soils.size());
    for (const Soil& one : soils)
      known.push_back(one.name);
    findings.add(table.path("soil"),
                 fmt::format("soil '{}' is not defined, {}", soil, suggestion(soil, known)));
  }
  return std::nullopt;
}

} // namespace tremolo::scene
