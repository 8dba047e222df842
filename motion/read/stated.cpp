#include "motion/read/stated.hpp"

#include "motion/read/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace tremolo::motion {

namespace {

[[noreturn]] void ask(const std::string& place, const std::string& text) {
  throw RecordError(fmt::format("{}: {}", place, text));
}

std::optional<Quantity> stated(const ReadAs& as, const std::string& place) {
  if (!as.unit)
    return as.quantity;
  if (as.quantity && *as.quantity != quantity_of(*as.unit))
    ask(place, fmt::format("{} is not a unit of {}", name(*as.unit), name(*as.quantity)));
  return quantity_of(*as.unit);
}

Quantity settled_quantity(const Stated& by_name, const Stated& by_header, const ReadAs& as,
                          const std::string& place) {
  const auto given = stated(as, place);
  const auto& a = by_name.quantity;
  const auto& b = by_header.quantity;
  if (given) {
    if ((a || b) && a != given && b != given)
      ask(place, fmt::format("the file holds {}, not {}", name(b ? *b : *a), name(*given)));
    return *given;
  }
  if (a && b && *a != *b)
    ask(place, fmt::format("the name says {}, the header {}: say which (--quantity)", name(*a), name(*b)));
  if (!a && !b)
    ask(place, "neither name nor header says whether this is acceleration, velocity or displacement: say "
               "which (--quantity or --unit)");
  return a ? *a : *b;
}

/// Puts the samples into the unit without its factor.
void take(Record& record, const ScaledUnit& unit, const std::string& place) {
  record.unit = unit.unit;
  const double largest = largest_sample / in_si(unit);
  for (std::size_t i = 0; i < record.samples.size(); ++i) {
    if (!(std::abs(record.samples[i]) <= largest))
      ask(place, fmt::format("sample {} is {:g} {}, must be within {:g} {}", i + 1, record.samples[i],
                             name(unit), largest_sample, name(si_unit(record.quantity()))));
    if (unit.factor != 1.0)
      record.samples[i] *= unit.factor;
  }
}

} // namespace

Stated stated_by_name(const std::filesystem::path& file) {
  const std::string extension = upper(file.extension().string());
  Stated stated;
  if (extension == ".AT2")
    stated.quantity = Quantity::acceleration;
  else if (extension == ".VT2")
    stated.quantity = Quantity::velocity;
  else if (extension == ".DT2")
    stated.quantity = Quantity::displacement;
  return stated;
}

Stated stated_in_peer(std::string_view line) {
  const std::string text = upper(line);
  const auto units = text.find("UNITS");
  if (units == std::string::npos)
    return {};
  // The text after the unit's sentence, such as filter points, does not describe the samples.
  std::size_t end = units;
  while (end < line.size() && line[end] != ';' &&
         !(line[end] == '.' &&
           (end + 1 == line.size() || std::isspace(static_cast<unsigned char>(line[end + 1])) != 0)))
    ++end;
  Stated stated = stated_in(line.substr(0, end), units);
  if (!stated.unit)
    stated.strange = shown(trimmed(line.substr(units, end - units)));
  return stated;
}

Unit peer_unit(Quantity quantity) {
  constexpr std::array peer = {Unit::g, Unit::cm_s, Unit::cm};
  return peer[static_cast<std::size_t>(quantity)];
}

void settle(Record& record, const Stated& by_name, const Stated& by_header, const ReadAs& as,
            bool fallback_to_peer, const std::string& place) {
  if (!(record.dt >= finest_step && record.dt <= coarsest_step))
    ask(place, fmt::format("a step of {} s, must be from {} to {} s", record.dt, finest_step, coarsest_step));
  if (!as.unit && !by_header.strange.empty())
    ask(place,
        fmt::format("'{}' is not wholly understood as a unit: say which (--unit), and a factor by --scale",
                    by_header.strange));
  const Quantity quantity = settled_quantity(by_name, by_header, as, place);
  record.kind = as.kind ? as.kind : by_header.kind;
  ScaledUnit unit;
  if (as.unit) {
    unit = {*as.unit};
    record.origin.unit = fmt::format("{} as given", name(unit));
    if (by_header.unit && *by_header.unit != unit)
      record.overruled_unit = by_header.unit;
    if (!by_header.strange.empty())
      record.origin.doubts.push_back(fmt::format(
          "the samples are taken in {} as given; the header says '{}', which is not wholly understood",
          name(unit), by_header.strange));
  } else if (by_header.unit && quantity_of(by_header.unit->unit) == quantity) {
    unit = *by_header.unit;
    record.origin.unit = fmt::format("{} as the file says", name(unit));
  } else if (fallback_to_peer) {
    unit = {peer_unit(quantity)};
    record.origin.unit = fmt::format("{}, PEER's own, as the file names none", name(unit));
  } else {
    ask(place,
        fmt::format("the header does not name the unit of the {}: say which (--unit)", name(quantity)));
  }
  take(record, unit, place);
}

} // namespace tremolo::motion
