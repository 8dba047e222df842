#pragma once

// A number that a file gives a law. Its name, unit, meaning and range stand once, in a table beside the law:
// the keys of files and their reference, the messages that refuse a value, and what `explain` and `soiltest`
// report follow from it.

#include "base/range.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::materials {

struct Parameter {
  std::string_view name;           ///< as in files
  std::string_view unit;           ///< as in files, "1" for none; laws have angles of "degrees" in rad
  std::string_view meaning;        ///< a few words
  Range range = {};                ///< in `unit`
  std::string_view fallback = {};  ///< default, as a file would say it
  std::string_view otherwise = {}; ///< in words, what holds without a value and without a fixed default
  std::string_view remark = {};    ///< further sentences, for the reference
  bool whole = false;              ///< an integer

  /// Whether a file must give it.
  bool needed() const { return fallback.empty() && otherwise.empty(); }
};

/// One parameter of a law as `tremolo explain` and `tremolo soiltest` print it.
struct ParameterValue {
  std::string_view name; ///< as in the case file
  double value = 0.0;
  std::string_view unit;    ///< "1" for none
  std::string_view meaning; ///< a few words
  std::string origin; ///< "given", or the rule it follows from, e.g. "default: max(0.3, (0.25 + D_R)/2)"
  std::string_view word = {}; ///< of a choice, what the file says; `value` is its number
};

/// The value in the law of one `unit`.
double in_law(const Parameter& parameter);

/// Refuses a value outside the range, or not finite.
/// @param value  as the law has it, rad for degrees
/// @throws std::invalid_argument with name, value and range as a file would say them
void check(const Parameter& parameter, double value);

/// Refuses a value above that of another parameter.
/// @param value, most  as the law has them
/// @throws std::invalid_argument with both names and values
void check_at_most(const Parameter& parameter, double value, const Parameter& other, double most);

/// What a report says of the value, as a file would.
/// @param value  as the law has it
ParameterValue report(const Parameter& parameter, double value, std::string origin = "given");

/// The parameter of this name.
/// @throws std::logic_error if there is none
const Parameter& find(std::span<const Parameter> parameters, std::string_view name);

/// A parameter that is a field of the law.
template <class Law>
struct LawField {
  Parameter text;
  double Law::*field;
};

/// A parameter that is a member of what the law is made from.
template <class Input>
struct InputField {
  Parameter text;
  std::optional<double>& (*member)(Input&);

  std::optional<double> given(Input input) const { return member(input); }
};

/// The texts of fields, with those that are none behind them.
template <class Fields>
std::vector<Parameter> texts(const Fields& fields, const std::vector<Parameter>& others = {}) {
  std::vector<Parameter> all;
  for (const auto& field : fields)
    all.push_back(field.text);
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

} // namespace tremolo::materials
