#include "motion/read/units.hpp"

#include "motion/read/text.hpp"
#include "motion/read/unit_grammar.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace tremolo::motion {

namespace {

using Kind = UnitToken::Kind;
using Tokens = std::vector<UnitToken>;

/// Words that speak of a factor and that no unit begins with.
constexpr std::array<std::string_view, 16> strange_words = {
    "cent",     "kilo",   "mega",   "hundred", "thousand", "million",    "times",      "multiplied",
    "multiply", "factor", "scaled", "scale",   "divided",  "normalised", "normalized", "counts"};

/// Words that say nothing of quantity or unit.
constexpr auto neutral_words = std::to_array<std::string_view>({"a",           "absolute",  "accelerogram",
                                                                "ag",          "amplitude", "an",
                                                                "and",         "are",       "at",
                                                                "ax",          "ay",        "az",
                                                                "base",        "bedrock",   "channel",
                                                                "component",   "corrected", "d",
                                                                "data",        "down",      "e",
                                                                "east",        "ew",        "filtered",
                                                                "for",         "from",      "ground",
                                                                "h",           "histories", "history",
                                                                "horizontal",  "in",        "input",
                                                                "is",          "l",         "longitudinal",
                                                                "motion",      "n",         "north",
                                                                "ns",          "of",        "outcropping",
                                                                "output",      "processed", "r",
                                                                "radial",      "record",    "recorded",
                                                                "relative",    "rock",      "series",
                                                                "soil",        "south",     "station",
                                                                "surface",     "t",         "the",
                                                                "time",        "top",       "total",
                                                                "transverse",  "u",         "ud",
                                                                "uncorrected", "unit",      "units",
                                                                "up",          "v",         "value",
                                                                "values",      "vertical",  "vs",
                                                                "w",           "west",      "x",
                                                                "y",           "z",         "s"});

std::optional<Quantity> quantity_begun_by(std::string_view word) {
  if (word.starts_with("acc"))
    return Quantity::acceleration;
  if (word.starts_with("vel"))
    return Quantity::velocity;
  if (word.starts_with("disp"))
    return Quantity::displacement;
  return std::nullopt;
}

bool is_factor(const UnitToken& token) {
  return token.is("*") || token.is("^") || token.is("%") || is_factor_word(token) ||
         is_one_of(token, strange_words);
}

/// Units and quantities found in the tokens of a text.
struct Parsed {
  std::vector<ScaledUnit> units;
  std::set<Quantity> quantities;
  std::set<MotionKind> kinds;
  bool strange = false;
};

class Parser {
public:
  Parser(const Tokens& tokens, std::size_t strict_from) : tokens_(tokens), strict_from_(strict_from) {
    for (std::size_t i = 0; i < tokens.size(); ++i)
      if (quantity_begun_by(tokens[i].text))
        last_quantity_ = i;
  }

  Parsed operator()() {
    int depth = 0;
    bool strange_in_brackets = false;
    bool strange_outside = false;
    for (std::size_t i = 0; i < tokens_.size();) {
      if (const auto found = unit_at(tokens_, i)) {
        found_.units.push_back(found->unit);
        i = found->end;
        unit_end_ = i;
        continue;
      }
      depth += tokens_[i].kind == Kind::open ? 1 : tokens_[i].kind == Kind::close ? -1 : 0;
      if (speaks_of_a_factor(i))
        found_.strange = true;
      else if (!is_understood(i))
        (depth > 0 ? strange_in_brackets : strange_outside) = true;
      ++i;
    }
    // Without a unit, a name that is not understood is only a name.
    found_.strange = found_.strange || strange_in_brackets || (strange_outside && !found_.units.empty());
    return found_;
  }

private:
  bool strict(std::size_t i) const { return tokens_[i].at >= strict_from_; }

  bool is_times(std::size_t i) const {
    return tokens_[i].is("x") &&
           ((i > 0 && tokens_[i - 1].is_number()) || (i + 1 < tokens_.size() && tokens_[i + 1].is_number()));
  }

  bool speaks_of_a_factor(std::size_t i) const {
    const UnitToken& token = tokens_[i];
    if (is_times(i) || is_factor(token))
      return true;
    if (!strict(i))
      return false;
    // "acc1", "ch 2": a digit that ends a name is part of it.
    const bool in_name = token.glued && i > 0 && i != unit_end_ && tokens_[i - 1].kind == Kind::word &&
                         token.value >= 0.0 && !is_second(tokens_[i - 1]);
    return token.is("/") || (token.is_number() && !in_name);
  }

  bool is_understood(std::size_t i) {
    const UnitToken& token = tokens_[i];
    if (token.kind != Kind::word)
      return true;
    if (const auto kind = kind_named(token.text)) {
      found_.kinds.insert(*kind);
      return true;
    }
    if (const auto quantity = quantity_begun_by(token.text)) {
      found_.quantities.insert(*quantity);
      return true;
    }
    if (!strict(i) || is_one_of(token, neutral_words))
      return true;
    // A title in front of "acceleration (g)".
    return found_.units.empty() && last_quantity_ && i < *last_quantity_;
  }

  const Tokens& tokens_;
  std::size_t strict_from_;
  std::optional<std::size_t> last_quantity_;
  std::size_t unit_end_ = 0; ///< the token behind the last unit
  Parsed found_;
};

template <class T>
std::optional<T> only(const std::set<T>& found) {
  return found.size() == 1 ? std::optional(*found.begin()) : std::nullopt;
}

} // namespace

Stated stated_in(std::string_view text, std::size_t strict_from) {
  const Tokens tokens = unit_tokens(text);
  const Parsed found = Parser(tokens, strict_from)();
  Stated stated{.quantity = only(found.quantities), .kind = only(found.kinds)};
  const bool agree =
      std::ranges::all_of(found.units, [&](const ScaledUnit& unit) { return unit == found.units.front(); });
  const bool contradicts =
      !found.units.empty() && stated.quantity && quantity_of(found.units.front().unit) != *stated.quantity;
  if (found.strange || !agree || contradicts) {
    stated.strange = shown(trimmed(text));
    return stated;
  }
  if (found.units.empty())
    return stated;
  stated.unit = found.units.front();
  if (found.quantities.empty())
    stated.quantity = quantity_of(stated.unit->unit);
  return stated;
}

std::optional<ScaledUnit> scaled_unit(std::string_view text) {
  const Tokens tokens = unit_tokens(text);
  const auto found = unit_at(tokens, 0);
  if (!found || found->end != tokens.size())
    return std::nullopt;
  return found->unit;
}

std::optional<double> seconds_per_time(std::string_view text) {
  constexpr std::array<std::string_view, 6> names = {"t", "time", "times", "elapsed", "in", "the"};
  constexpr std::array<UnitWord, 12> other_units = {{{"ms", 1e-3},
                                                     {"msec", 1e-3},
                                                     {"msecs", 1e-3},
                                                     {"millisecond", 1e-3},
                                                     {"milliseconds", 1e-3},
                                                     {"us", 1e-6},
                                                     {"usec", 1e-6},
                                                     {"microsecond", 1e-6},
                                                     {"microseconds", 1e-6},
                                                     {"min", 60.0},
                                                     {"minute", 60.0},
                                                     {"minutes", 60.0}}};
  std::optional<double> unit;
  bool named = false;
  for (const UnitToken& token : unit_tokens(text)) {
    if (token.kind == Kind::open || token.kind == Kind::close)
      continue;
    auto seconds_of_it = value_of(token, other_units);
    if (is_second(token))
      seconds_of_it = 1.0;
    if (seconds_of_it && unit)
      return std::nullopt;
    if (seconds_of_it)
      unit = seconds_of_it;
    else if (!is_one_of(token, names))
      return std::nullopt;
    named = true;
  }
  if (!named)
    return std::nullopt;
  return unit.value_or(1.0);
}

} // namespace tremolo::motion
