#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

namespace tremolo::scene {

namespace {

/// Symbols of a law's report that have a name in words in files.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> in_words = {
    {{"G_o", "shear_modulus_coefficient"}, {"h_po", "contraction_rate"}, {"p_A", "atmospheric_pressure"}}};

ParameterInForce in_terms_of_the_file(const materials::ParameterValue& parameter) {
  ParameterInForce shown{std::string(parameter.name),    parameter.value,  std::string(parameter.unit),
                         std::string(parameter.meaning), parameter.origin, std::string(parameter.word)};
  if (const auto* word = std::ranges::find(in_words, parameter.name, &decltype(in_words)::value_type::first);
      word != in_words.end()) {
    shown.meaning = fmt::format("{}, {}", parameter.name, parameter.meaning);
    shown.name = word->second;
  }
  if (parameter.unit == "rad") {
    shown.name += "_deg";
    shown.value *= 180.0 / std::numbers::pi;
    shown.unit = "degrees";
  }
  return shown;
}

} // namespace

std::string model_in_force(const std::string& table, const std::vector<ValueInForce>& values) {
  const auto value = std::ranges::find(values, table + ".model", &ValueInForce::key);
  if (value == values.end())
    return {};
  return value->value.substr(1, value->value.size() - 2); // without the quotes of TOML
}

std::vector<ParameterInForce> parameters_in_force(const Soil& soil, const std::string& table,
                                                  const std::vector<ValueInForce>& values) {
  std::vector<ParameterInForce> parameters;
  for (const auto& parameter : materials::parameters(soil.column_law)) {
    auto shown = in_terms_of_the_file(parameter);
    const auto value = std::ranges::find(values, fmt::format("{}.{}", table, shown.name), &ValueInForce::key);
    if (value != values.end() && shown.origin == "given")
      shown.origin = value->origin;
    parameters.push_back(std::move(shown));
  }
  return parameters;
}

std::optional<ImpliedStrength> implied_strength(const Soil& soil) {
  constexpr double strain = 0.1;
  constexpr double tolerance = 0.1; // of the strength
  const auto backbone = materials::shear_backbone(soil.column_law);
  if (!backbone || !soil.given_strength)
    return std::nullopt;
  const double ratio = backbone->stress(strain) / *soil.given_strength;
  const bool near = ratio >= 1.0 - tolerance && ratio <= 1.0 + tolerance;
  return ImpliedStrength{
      fmt::format(
          "soil '{}': at {:.0f} % shear strain its backbone has {:.4g} kPa, {:.2f} times the strength given, "
          "{:.4g} kPa{}",
          soil.name, 100.0 * strain, 1e-3 * backbone->stress(strain), ratio, 1e-3 * *soil.given_strength,
          near || backbone->shape ? "" : "; model = \"gqh\" keeps to the strength"),
      near};
}

std::string text(const std::vector<ParameterInForce>& parameters) {
  std::string lines;
  for (const auto& [name, value, unit, meaning, origin, word] : parameters)
    lines += fmt::format("  {:<26} {:>12} {:<8} {} ({})\n", name,
                         word.empty() ? fmt::format("{:.6g}", value) : word, unit == "1" ? "" : unit, meaning,
                         origin);
  return lines;
}

} // namespace tremolo::scene
