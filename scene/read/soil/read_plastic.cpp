#include "scene/read/soil/read_soil.hpp"

#include <fmt/format.h>

#include <exception>

namespace tremolo::scene {

namespace {

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
  if (!within(table, "surfaces", {.low = group, .high = 60.0}, "", findings))
    return false;
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
  need(table, "density", findings);
  if (table.choice<SoilModel>("model") == SoilModel::drucker_prager)
    need(table, "friction_deg", findings);
  const auto elastic = read_elasticity(table, findings);
  for (const char* key : {"density", "young", "poisson", "vs", "vp", "cohesion", "friction_deg",
                          "dilation_deg", "undrained_strength", "peak_strain", "surfaces", "curve"})
    if (!findings.sound(table.path(key)))
      return placeholder(soil.name);
  if (!(elastic.density > 0.0 && elastic.young > 0.0))
    return placeholder(soil.name);
  if (!sound_count(table, findings))
    return placeholder(soil.name);
  try {
    const materials::Law law = table.choice<SoilModel>("model") == SoilModel::drucker_prager
                                   ? materials::Law(materials::DruckerPrager{
                                         .elastic = elastic,
                                         .cohesion = table.number("cohesion"),
                                         .friction = table.number("friction_deg") * degree,
                                         .dilation = table.number("dilation_deg") * degree,
                                         .match = value_named<materials::ConeMatch>(table.text("cone"))
                                                      .value_or(materials::ConeMatch::plane_strain)})
                                   : clay(table, elastic, directory);
    materials::validate(law);
    return {soil.name, law, law, {}, {}};
  } catch (const std::exception& error) {
    findings.add(table.path(), error.what());
    return placeholder(soil.name);
  }
}

} // namespace tremolo::scene
