#include "scene/soils/plausible.hpp"

#include "scene/choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

namespace tremolo::scene {

namespace {

/// A unit that a number is often given in by mistake.
struct OtherUnit {
  std::string_view name;
  double in_si = 1.0; ///< one of it in the SI unit of the key
};

constexpr double standard_gravity = 9.81; // m/s2
constexpr double conductivity_per_area =
    standard_gravity * 1e3 / 1e-3; // rho g/mu of water, 1/(m s): k = K rho g/mu

constexpr std::array stress_units = {OtherUnit{"kPa", 1e3}, OtherUnit{"MPa", 1e6}, OtherUnit{"GPa", 1e9}};
constexpr std::array density_units = {OtherUnit{"t/m3", 1e3}, OtherUnit{"kN/m3", 1e3 / standard_gravity},
                                      OtherUnit{"N/m3", 1.0 / standard_gravity}};
constexpr std::array speed_units = {OtherUnit{"km/s", 1e3}};
constexpr std::array conductivity_units = {OtherUnit{"m2", conductivity_per_area},
                                           OtherUnit{"m/day", 1.0 / 86400.0}, OtherUnit{"cm/s", 0.01}};

/// Usual magnitude of a key's value.
struct Plausible {
  std::string_view key; ///< its table, without the name of a soil, and itself
  double least = 0.0;
  double most = 0.0;
  bool zero = false; ///< 0 means that there is none
  std::string_view unit;
  std::string_view of; ///< "is that of no ..."
  std::span<const OtherUnit> others;
  std::string_view example = {};
  std::array<std::string_view, 2> models = {}; ///< of soil; empty: all
};

constexpr std::string_view sand_example = "kg/m3 are meant, 1700 for a dry sand";
constexpr std::string_view built_example =
    "kg/m3 are meant, 2400 for concrete, about 300 for a building with its rooms";
constexpr std::string_view concrete_example = "kg/m3 are meant, 2400 for concrete";
constexpr std::array<std::string_view, 2> sands = {"pm4sand", "pdmy03"};

// Peat has waves of some 20 m/s; sound rock has E up to 1e11 Pa and c_p up to 8 km/s. Slurry has some
// hundred Pa of strength, and a cohesion below that has no effect. Gravel lets 0.1 m/s through, silty sand
// 1e-8, unfissured clay and rock salt 1e-13.
constexpr std::array plausible_ranges = std::to_array<Plausible>({
    {"soil.density", 500.0, 8000.0, false, "kg/m3", "soil or rock", density_units, sand_example},
    {"halfspace.density", 500.0, 8000.0, false, "kg/m3", "soil or rock", density_units, sand_example},
    {"profile.density", 500.0, 8000.0, false, "kg/m3", "soil or rock", density_units, sand_example},
    {"structure.density", 10.0, 2e4, false, "kg/m3", "structure", density_units, built_example},
    {"lining.density", 10.0, 2e4, false, "kg/m3", "lining", density_units, concrete_example},
    {"soil.young", 2e5, 5e11, false, "Pa", "soil or rock", stress_units},
    {"halfspace.young", 2e5, 5e11, false, "Pa", "soil or rock", stress_units},
    {"profile.young", 2e5, 5e11, false, "Pa", "soil or rock", stress_units},
    {"structure.young", 2e5, 5e12, false, "Pa", "structure", stress_units},
    {"lining.young", 1e7, 5e12, false, "Pa", "lining", stress_units},
    {"soil.vs", 10.0, 6e3, false, "m/s", "soil or rock", speed_units},
    {"halfspace.vs", 10.0, 6e3, false, "m/s", "soil or rock", speed_units},
    {"profile.vs", 10.0, 6e3, false, "m/s", "soil or rock", speed_units},
    {"soil.vp", 12.0, 1e4, false, "m/s", "soil or rock", speed_units},
    {"halfspace.vp", 12.0, 1e4, false, "m/s", "soil or rock", speed_units},
    {"profile.vp", 12.0, 1e4, false, "m/s", "soil or rock", speed_units},
    {"soil.shear_modulus", 1e6, 1e11, false, "Pa", "soil or rock", stress_units},
    {"soil.bulk_modulus", 1e6, 5e11, false, "Pa", "soil or rock", stress_units},
    {"soil.cohesion", 100.0, 1e8, true, "Pa", "soil or rock", stress_units},
    {"soil.cohesion_peak", 100.0, 1e8, true, "Pa", "soil or rock", stress_units},
    {"soil.cohesion_residual", 100.0, 1e8, true, "Pa", "soil or rock", stress_units},
    {"soil.tension_cutoff", 100.0, 1e8, true, "Pa", "soil or rock", stress_units},
    {"soil.undrained_strength", 1e3, 1e7, false, "Pa", "clay", stress_units},
    {"soil.shear_strength", 1e3, 1e8, false, "Pa", "soil or rock", stress_units},
    {"soil.zero_pressure_strength", 10.0, 1e5, true, "Pa", "sand", stress_units},
    {"soil.mean_stress", 1e3, 1e8, false, "Pa", "ground", stress_units},
    {"soil.reference_pressure", 1e3, 1e8, false, "Pa", "ground", stress_units},
    {"soil.p_sedo", 200.0, 1e7, false, "Pa", "sand", stress_units},
    {"soil.atmospheric_pressure", 5e4, 1.5e5, false, "Pa", "atmosphere", stress_units},
    {"soil.permeability", 1e-8, 0.1, false, "m/s", "sand", conductivity_units, {}, sands},
    {"soil.permeability", 1e-13, 0.1, false, "m/s", "soil finer than gravel", conductivity_units},
    {"water.bulk_modulus", 1e6, 1e10, false, "Pa", "water", stress_units},
    {"water.cavitation_pressure", 1e3, 1e8, true, "Pa", "water", stress_units},
    {"structure.adhesion", 100.0, 1e8, true, "Pa", "surface on soil", stress_units},
    {"structure.against.adhesion", 100.0, 1e8, true, "Pa", "surface on soil", stress_units},
    {"test.vertical_stress", 1e3, 1e8, false, "Pa", "specimen", stress_units},
});

/// "soil.clay.young" -> "soil.young", "boundary.left.profile[2].density" -> "profile.density".
std::string without_names(std::string_view path) {
  std::string plain;
  for (bool index = false; const char letter : path) {
    index = letter == '[' || (index && letter != ']');
    if (!index && letter != ']')
      plain += letter;
  }
  for (const std::string_view side : {"boundary.left.", "boundary.right."})
    if (plain.starts_with(side))
      plain.erase(0, side.size());
  constexpr std::string_view soil = "soil.";
  if (plain.starts_with(soil))
    plain = std::string(soil) + plain.substr(plain.find_last_of('.') + 1);
  return plain;
}

const Plausible* row_of(std::string_view path, std::string_view model) {
  const std::string key = without_names(path);
  const auto row = std::ranges::find_if(plausible_ranges, [&](const Plausible& one) {
    return one.key == key &&
           (one.models.front().empty() || std::ranges::find(one.models, model) != one.models.end());
  });
  return row == plausible_ranges.end() ? nullptr : &*row;
}

/// A number to four digits, without an exponent below a million.
std::string rounded(double value) {
  return fmt::format("{:g}", std::stod(fmt::format("{:.3e}", value)));
}

std::optional<double> number_in(std::string_view toml) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(toml.data(), toml.data() + toml.size(), value);
  return error == std::errc{} && end == toml.data() + toml.size() ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<std::string> unit_doubt(std::string_view path, double value, std::string_view model) {
  const Plausible* row = row_of(path, model);
  const auto fits = [&](double magnitude) { return magnitude >= row->least && magnitude <= row->most; };
  if (row == nullptr || fits(std::abs(value)) || (row->zero && value == 0.0))
    return std::nullopt;
  std::string text =
      fmt::format("'{}' = {:g} {} is that of no {}, {:g} to {:g}", path.substr(path.find_last_of('.') + 1),
                  value, row->unit, row->of, row->least, row->most);
  if (!row->example.empty())
    text += fmt::format(": {}", row->example);
  std::string_view link = "; ";
  for (const auto& [unit, in_si] : row->others)
    if (fits(std::abs(in_si * value))) {
      text += fmt::format("{}{:g} {} would be {}", link, value, unit, rounded(in_si * value));
      link = ", ";
    }
  return text;
}

std::vector<std::pair<std::string, std::string>> unit_doubts(const std::vector<ValueInForce>& values) {
  std::vector<std::pair<std::string, std::string>> doubts;
  for (const auto& [key, value, origin] : values) {
    const auto number = origin == "default" ? std::nullopt : number_in(value);
    if (!number)
      continue;
    const auto model =
        std::ranges::find(values, key.substr(0, key.find_last_of('.')) + ".model", &ValueInForce::key);
    const std::string_view word = model == values.end() ? std::string_view{} : std::string_view(model->value);
    if (const auto doubt = unit_doubt(key, *number, word.size() > 2 ? word.substr(1, word.size() - 2) : word))
      doubts.emplace_back(key, *doubt);
  }
  return doubts;
}

} // namespace tremolo::scene
