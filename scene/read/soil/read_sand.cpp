#include "scene/keys/soil/keys_law.hpp"
#include "scene/read/soil/read_soil.hpp"
#include "scene/read/soil/read_water.hpp"
#include "scene/soils/plausible.hpp"
#include "scene/soils/soil_library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <stdexcept>

namespace tremolo::scene {

namespace {

materials::Pm4SandInput pm4sand_input(const TableReader& table) {
  materials::Pm4SandInput input{.post_shake = table.boolean("post_shake")};
  read_into(input, materials::pm4sand_parameters(), table);
  return input;
}

/// G/Gmax that the surfaces share. The built-in curve at as many strains as there are surfaces by default.
std::vector<materials::ModulusReduction> modulus_reduction(const TableReader& table,
                                                           const std::filesystem::path& directory) {
  if (!table.given("curve"))
    return {};
  const auto curve = read_curve(table, directory);
  std::vector<materials::ModulusReduction> points;
  if (table.text("curve") != built_in_curve) {
    for (std::size_t i = 0; i < curve.strain.size(); ++i)
      points.push_back({curve.strain[i], curve.modulus_ratio[i]});
    return points;
  }
  constexpr int count = 20;
  for (int i = 0; i < count; ++i) {
    const double strain = std::pow(10.0, -5.0 + 4.0 * i / (count - 1));
    points.push_back({strain, curve.modulus_ratio_at(strain)});
  }
  return points;
}

materials::Law pdmy03(const TableReader& table, const std::filesystem::path& directory) {
  materials::Pdmy03Input input{.cone = value_named<materials::Pdmy03Cone>(table.text("cone")),
                               .modulus_reduction = modulus_reduction(table, directory)};
  read_into(input, materials::pdmy03_parameters(), table);
  return materials::pdmy03(input);
}

/// Whether the density, where there is one, has a recommended set.
bool recommended(const TableReader& table, Findings& findings) {
  const auto density = table.optional_number("relative_density");
  try {
    if (density)
      materials::pdmy03_recommended(*density);
    return true;
  } catch (const std::invalid_argument& error) {
    findings.add(table.path("relative_density"), error.what());
    return false;
  }
}

/// Whether nothing is given twice: by a curve, and by what it fixes.
bool given_once(const TableReader& table, Findings& findings) {
  bool once = true;
  for (const char* key : {"friction_deg", "surfaces", "peak_shear_strain"})
    if (table.given("curve") && table.given(key)) {
      findings.add(
          table.path(key),
          fmt::format("'{}' and 'curve' exclude each other: the curve fixes friction angle, surfaces "
                      "and their last strain; remove one",
                      key));
      once = false;
    }
  return once;
}

/// The law compares moduli and pressures with each other: which of those that it refuses are likely to be in
/// another unit.
std::string pressure_doubts(const TableReader& table) {
  std::string text;
  for (const materials::Parameter& parameter : parameters_of(table.choice<SoilModel>("model")))
    if (const auto value = table.optional_number(parameter.name); value && parameter.unit == "Pa")
      if (const auto doubt = unit_doubt(table.path(parameter.name), *value))
        text += "; " + *doubt;
  return text;
}

} // namespace

std::optional<double> void_ratio_of_law(const TableReader& table) {
  if (table.text("model") != name(SoilModel::pm4sand))
    return std::nullopt;
  auto input = pm4sand_input(table);
  input.density = 1.0; // the void ratio does not go with it, and it may have to follow from the void ratio
  try {
    const auto law = materials::pm4sand(input);
    return law.e_max - law.relative_density * (law.e_max - law.e_min);
  } catch (const std::invalid_argument&) {
    return std::nullopt; // reported when the soil is read
  }
}

std::optional<double> saturated_density_of_law(const TableReader& table) {
  if (table.text("model") != name(SoilModel::pdmy03))
    return std::nullopt;
  if (const auto density = table.optional_number("density"))
    return density;
  try {
    const auto set = table.optional_number("relative_density");
    return set ? materials::pdmy03_recommended(*set).density : std::nullopt;
  } catch (const std::invalid_argument&) {
    return std::nullopt; // reported when the soil is read
  }
}

Soil read_sand(const NamedTable& soil, const std::filesystem::path& directory, Findings& findings) {
  const auto& table = soil.reader;
  const auto model = table.choice<SoilModel>("model");
  const bool pm4 = model == SoilModel::pm4sand;
  if (!sound_numbers(table, model, findings) || !findings.sound(table.path("curve")) ||
      (!pm4 && (!recommended(table, findings) || !given_once(table, findings))))
    return placeholder(soil.name);
  try {
    const materials::Law law =
        pm4 ? materials::Law(materials::pm4sand(pm4sand_input(table))) : pdmy03(table, directory);
    return {soil.name, law, law, {}, {}};
  } catch (const std::exception& error) {
    findings.add(table.path(), error.what() + pressure_doubts(table));
    return placeholder(soil.name);
  }
}

} // namespace tremolo::scene
