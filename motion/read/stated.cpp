#include "motion/read/stated.hpp"

#include "motion/read/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <vector>

namespace tremolo::motion {

namespace {

/// Words of letters, digits and the signs that units are written with. "acc_g", "v_cm_s" and "cm/s/s" come
/// out as ACC G, V CM/S and CM/S/S.
std::vector<std::string> unit_words(std::string_view text) {
  std::vector<std::string> found(1);
  for (const char c : upper(text)) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/' || c == '*' || c == '^' ||
        static_cast<unsigned char>(c) >= 0x80)
      found.back().push_back(c);
    else if (!found.back().empty())
      found.emplace_back();
  }
  for (std::size_t i = 1; i < found.size(); ++i) {
    const bool length = found[i - 1] == "M" || found[i - 1] == "CM";
    if (length && (found[i] == "S" || found[i] == "S2")) {
      found[i] = found[i - 1] + "/" + found[i];
      found[i - 1].clear();
    }
  }
  std::erase(found, "");
  return found;
}

std::optional<Quantity> quantity_begun_by(std::string_view word) {
  if (word.starts_with("ACC"))
    return Quantity::acceleration;
  if (word.starts_with("VEL"))
    return Quantity::velocity;
  if (word.starts_with("DISP"))
    return Quantity::displacement;
  return std::nullopt;
}

template <class T>
std::optional<T> only(const std::set<T>& found) {
  return found.size() == 1 ? std::optional(*found.begin()) : std::nullopt;
}

[[noreturn]] void ask(const std::string& place, const std::string& text) {
  throw RecordError(fmt::format("{}: {}", place, text));
}

std::optional<Quantity> told(const ReadAs& as, const std::string& place) {
  if (!as.unit)
    return as.quantity;
  if (as.quantity && *as.quantity != quantity_of(*as.unit))
    ask(place, fmt::format("{} is not a unit of {}", name(*as.unit), name(*as.quantity)));
  return quantity_of(*as.unit);
}

Quantity settled_quantity(const Stated& by_name, const Stated& by_header, const ReadAs& as,
                          const std::string& place) {
  const auto given = told(as, place);
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

Stated stated_in(std::string_view text) {
  std::set<Quantity> quantities;
  std::set<Unit> units;
  std::set<MotionKind> kinds;
  for (const std::string& word : unit_words(text)) {
    if (const auto unit = unit_named(word))
      units.insert(*unit);
    else if (const auto kind = kind_named(word))
      kinds.insert(*kind);
    else if (const auto quantity = quantity_begun_by(word))
      quantities.insert(*quantity);
  }
  Stated stated{.quantity = only(quantities), .unit = only(units), .kind = only(kinds), .strange_unit = {}};
  if (stated.unit && stated.quantity && quantity_of(*stated.unit) != *stated.quantity)
    return {.kind = stated.kind};
  if (stated.unit && quantities.empty())
    stated.quantity = quantity_of(*stated.unit);
  return stated;
}

Stated stated_in_peer(std::string_view line) {
  const std::string text = upper(line);
  const auto units = text.find("UNITS");
  if (units == std::string::npos)
    return {};
  // What follows the unit's sentence, such as filter points, does not speak of the samples.
  const auto end = text.find_first_of(".;", units);
  Stated stated = stated_in(text.substr(0, end));
  if (!stated.unit)
    stated.strange_unit = shown(text.substr(units, end == std::string::npos ? end : end - units));
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
  const Quantity quantity = settled_quantity(by_name, by_header, as, place);
  record.kind = as.kind ? as.kind : by_header.kind;
  if (as.unit) {
    record.unit = *as.unit;
    if (by_header.unit && *by_header.unit != *as.unit)
      record.overruled_unit = by_header.unit;
  } else if (by_header.unit && quantity_of(*by_header.unit) == quantity) {
    record.unit = *by_header.unit;
  } else if (!by_header.strange_unit.empty()) {
    ask(place, fmt::format("'{}': no unit that is known; say which (--unit)", by_header.strange_unit));
  } else if (fallback_to_peer) {
    record.unit = peer_unit(quantity);
  } else {
    ask(place,
        fmt::format("the header does not name the unit of the {}: say which (--unit)", name(quantity)));
  }
}

} // namespace tremolo::motion
