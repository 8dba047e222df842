#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tremolo::scene {

namespace {

ParameterInForce shown(const materials::ParameterValue& parameter) {
  return {std::string(parameter.name),    parameter.value,  std::string(parameter.unit),
          std::string(parameter.meaning), parameter.origin, std::string(parameter.word)};
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
    auto one = shown(parameter);
    const auto value = std::ranges::find(values, fmt::format("{}.{}", table, one.name), &ValueInForce::key);
    if (value != values.end() && one.origin == "given")
      one.origin = value->origin;
    parameters.push_back(std::move(one));
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
