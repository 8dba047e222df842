#include "motion/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace tremolo::motion {

namespace {

struct UnitEntry {
  Unit unit;
  Quantity quantity;
  double si;
};

constexpr std::array units = {
    UnitEntry{Unit::g, Quantity::acceleration, standard_gravity},
    UnitEntry{Unit::m_s2, Quantity::acceleration, 1.0},
    UnitEntry{Unit::cm_s2, Quantity::acceleration, 0.01},
    UnitEntry{Unit::m_s, Quantity::velocity, 1.0},
    UnitEntry{Unit::cm_s, Quantity::velocity, 0.01},
    UnitEntry{Unit::m, Quantity::displacement, 1.0},
    UnitEntry{Unit::cm, Quantity::displacement, 0.01},
    UnitEntry{Unit::mm, Quantity::displacement, 0.001},
};

const UnitEntry& entry(Unit unit) {
  return *std::ranges::find(units, unit, &UnitEntry::unit);
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

} // namespace

std::optional<Quantity> quantity_named(std::string_view text) {
  return value_named<Quantity>(lower(text));
}

std::optional<MotionKind> kind_named(std::string_view text) {
  return value_named<MotionKind>(lower(text));
}

std::optional<Unit> unit_named(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> spellings = {
      {{"sec", "s"}, {"**", ""}, {"^", ""}, {"\u00b2", "2"}, {"gal", "cm/s2"}, {"/s/s", "/s2"}}};
  std::string plain = lower(text);
  for (const auto& [from, to] : spellings)
    replace_all(plain, from, to);
  return value_named<Unit>(plain);
}

Quantity quantity_of(Unit unit) {
  return entry(unit).quantity;
}

double in_si(Unit unit) {
  return entry(unit).si;
}

std::string name(const ScaledUnit& unit) {
  return unit.factor == 1.0 ? std::string(name(unit.unit))
                            : fmt::format("{:g} {}", unit.factor, name(unit.unit));
}

double in_si(const ScaledUnit& unit) {
  return unit.factor * in_si(unit.unit);
}

Unit si_unit(Quantity quantity) {
  constexpr std::array si = {Unit::m_s2, Unit::m_s, Unit::m};
  return si[static_cast<std::size_t>(quantity)];
}

} // namespace tremolo::motion
