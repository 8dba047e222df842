#include "scene/read/soil/read_soil.hpp"

#include <fmt/format.h>

#include <exception>

namespace tremolo::scene {

namespace {

/// A law whose numbers are its fields.
materials::Law of_fields(materials::Law law, const TableReader& table) {
  read_fields(law, table);
  return law;
}

materials::Law of_model(SoilModel model, const TableReader& table, const materials::Elasticity& elastic) {
  if (model != SoilModel::drucker_prager)
    return of_fields(materials::law_of_fields(name(model), elastic).value(), table);
  const auto match = value_named<materials::ConeMatch>(table.text("cone"));
  return of_fields(materials::DruckerPrager{.elastic = elastic,
                                            .match = match.value_or(materials::ConeMatch::plane_strain)},
                   table);
}

materials::Law clay(const TableReader& table, const materials::Elasticity& elastic,
                    const std::filesystem::path& directory) {
  const double strength = table.number("undrained_strength");
  const double peak_strain = table.number("peak_strain");
  if (table.given("curve"))
    return materials::multi_yield_clay(elastic, strength, read_curve(table, directory), peak_strain);
  materials::ClaySurfaces surfaces{.peak_strain = peak_strain};
  if (const auto count = table.optional_number("surfaces"))
    surfaces.count = static_cast<std::size_t>(*count);
  return materials::multi_yield_clay(elastic, strength, surfaces);
}

/// Surfaces of the clay are updated in groups of four.
bool sound_count(const TableReader& table, Findings& findings) {
  constexpr int group = 4;
  const int count = table.integer("surfaces");
  if (count % group == 0)
    return true;
  findings.add(table.path("surfaces"),
               fmt::format("'surfaces' = {} must be a multiple of {} with model = \"multi_yield_clay\"",
                           count, group));
  return false;
}

} // namespace

Soil read_plastic(const NamedTable& soil, const std::filesystem::path& directory, Findings& findings) {
  const auto& table = soil.reader;
  const auto model = table.choice<SoilModel>("model");
  const bool sound = sound_numbers(table, model, findings);
  const auto elastic = read_elasticity(table, findings);
  if (!sound || !findings.sound(table.path("curve")))
    return placeholder(soil.name);
  if (!(elastic.density > 0.0 && elastic.young > 0.0))
    return placeholder(soil.name);
  if (model == SoilModel::multi_yield_clay && !sound_count(table, findings))
    return placeholder(soil.name);
  try {
    const materials::Law law = model == SoilModel::multi_yield_clay ? clay(table, elastic, directory)
                                                                    : of_model(model, table, elastic);
    materials::validate(law);
    return {soil.name, law, law, {}, {}};
  } catch (const std::exception& error) {
    findings.add(table.path(), error.what());
    return placeholder(soil.name);
  }
}

} // namespace tremolo::scene
