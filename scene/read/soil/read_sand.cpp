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

/// Hands out the optional numbers of a table.
class Numbers {
public:
  explicit Numbers(const TableReader& table) : table_(table) {}
  std::optional<double> operator()(std::string_view key) const { return table_.optional_number(key); }
  std::optional<double> angle(std::string_view key) const {
    const auto value = table_.optional_number(key);
    return value ? std::optional(*value * degree) : std::nullopt;
  }

private:
  const TableReader& table_;
};

materials::Pm4SandInput pm4sand_input(const TableReader& table) {
  const Numbers number(table);
  return {.density = table.number("density"),
          .relative_density = table.number("relative_density"),
          .G_o = table.number("shear_modulus_coefficient"),
          .h_po = table.number("contraction_rate"),
          .p_A = number("atmospheric_pressure"),
          .e_max = number("e_max"),
          .e_min = number("e_min"),
          .n_b = number("n_b"),
          .n_d = number("n_d"),
          .phi_cv = number.angle("phi_cv_deg"),
          .poisson = number("poisson"),
          .Q = number("Q"),
          .R = number("R"),
          .m = number("m"),
          .h_o = number("h_o"),
          .A_do = number("A_do"),
          .z_max = number("z_max"),
          .c_z = number("c_z"),
          .c_eps = number("c_eps"),
          .C_GD = number("C_GD"),
          .C_DR = number("C_DR"),
          .C_kaf = number("C_kaf"),
          .F_sed_min = number("F_sed_min"),
          .p_sedo = number("p_sedo"),
          .post_shake = table.boolean("post_shake")};
}

materials::Law pm4sand(const TableReader& table) {
  materials::Pm4Sand law = materials::pm4sand(pm4sand_input(table));
  law.integration.tolerance = table.number("tolerance");
  return law;
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
  const Numbers number(table);
  return materials::pdmy03(
      {.relative_density = number("relative_density"),
       .density = number("density"),
       .shear_modulus = number("shear_modulus"),
       .bulk_modulus = number("bulk_modulus"),
       .friction = number.angle("friction_deg"),
       .phase_transformation = number.angle("phase_transformation_deg"),
       .contraction = {number("contraction_a"), number("contraction_b"), number("contraction_c"),
                       number("contraction_d"), number("contraction_e")},
       .dilation = {number("dilation_a"), number("dilation_b"), number("dilation_c")},
       .peak_shear_strain = number("peak_shear_strain"),
       .reference_pressure = number("reference_pressure"),
       .pressure_exponent = number("pressure_exponent"),
       .surfaces = number("surfaces"),
       .liquefaction_1 = number("liquefaction_1"),
       .liquefaction_2 = number("liquefaction_2"),
       .atmospheric_pressure = number("atmospheric_pressure"),
       .zero_pressure_strength = number("zero_pressure_strength"),
       .cone = value_named<materials::Pdmy03Cone>(table.text("cone")),
       .modulus_reduction = modulus_reduction(table, directory)});
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

/// Whether the keys that other models have too suit this one.
bool suits_pdmy03(const TableReader& table, Findings& findings) {
  bool good = within(table, "friction_deg", {.low = 1.0, .high = 65.0}, " degrees", findings);
  good &= within(table, "surfaces", {.low = 3.0, .high = 40.0}, "", findings);
  if (!table.given("curve"))
    return good;
  for (const char* key : {"friction_deg", "surfaces", "peak_shear_strain"})
    if (table.given(key)) {
      findings.add(
          table.path(key),
          fmt::format("'{}' and 'curve' exclude each other: the curve fixes friction angle, surfaces "
                      "and their last strain; remove one",
                      key));
      good = false;
    }
  return good;
}

/// The law compares moduli and pressures with each other: which of those that it refuses are likely to be in
/// another unit.
std::string pressure_doubts(const TableReader& table) {
  std::string text;
  for (const char* key : {"shear_modulus", "bulk_modulus", "reference_pressure", "atmospheric_pressure",
                          "zero_pressure_strength", "p_sedo"})
    if (const auto value = table.optional_number(key))
      if (const auto doubt = unit_doubt(table.path(key), *value))
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
  const bool pm4 = table.choice<SoilModel>("model") == SoilModel::pm4sand;
  if (pm4) {
    need(table, "density", findings);
    need(table, "relative_density", findings);
  }
  for (const char* key : {"density", "relative_density", "shear_modulus_coefficient", "contraction_rate",
                          "friction_deg", "surfaces", "curve"})
    if (!findings.sound(table.path(key)))
      return placeholder(soil.name);
  if (!pm4 && (!recommended(table, findings) || !suits_pdmy03(table, findings)))
    return placeholder(soil.name);
  try {
    const materials::Law law = pm4 ? pm4sand(table) : pdmy03(table, directory);
    return {soil.name, law, law, {}, {}};
  } catch (const std::exception& error) {
    findings.add(table.path(), error.what() + pressure_doubts(table));
    return placeholder(soil.name);
  }
}

} // namespace tremolo::scene
