#include "materials/law/parameter.hpp"

#include "base/text/unit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace tremolo::materials {

double in_law(const Parameter& parameter) {
  return parameter.unit == "degrees" ? std::numbers::pi / 180.0 : 1.0;
}

namespace {

/// A number in the unit of the file.
std::string shown(const Parameter& parameter, double value) {
  return with_unit(fmt::format("{:.6g}", value / in_law(parameter)), parameter.unit);
}

} // namespace

void check(const Parameter& parameter, double value) {
  const double given = value / in_law(parameter);
  // An angle at the end of its range comes back from rad with rounding.
  const double least = parameter.range.low;
  const double most = parameter.range.high;
  const double near = 1e-12 * std::abs(given);
  const bool at_an_end = (!parameter.range.low_open && std::abs(given - least) <= near) ||
                         (!parameter.range.high_open && std::abs(given - most) <= near);
  if (!parameter.range.contains(given) && !at_an_end)
    throw std::invalid_argument(fmt::format("{} = {} is out of range, must be {}", parameter.name,
                                            shown(parameter, value),
                                            with_unit(parameter.range.text(), parameter.unit)));
}

void check_at_most(const Parameter& parameter, double value, const Parameter& other, double most) {
  if (!(value <= most))
    throw std::invalid_argument(fmt::format("{} = {} is above {} = {}", parameter.name,
                                            shown(parameter, value), other.name, shown(other, most)));
}

ParameterValue report(const Parameter& parameter, double value, std::string origin) {
  return {parameter.name, value / in_law(parameter), parameter.unit, parameter.meaning, std::move(origin)};
}

const Parameter& find(std::span<const Parameter> parameters, std::string_view name) {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  if (found == parameters.end())
    throw std::logic_error(fmt::format("no parameter '{}'", name));
  return *found;
}

} // namespace tremolo::materials
