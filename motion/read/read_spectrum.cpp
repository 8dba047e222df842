#include "motion/read/read_spectrum.hpp"

#include "base/text/unreadable.hpp"
#include "motion/read/text.hpp"
#include "motion/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>

namespace tremolo::motion {

namespace {

constexpr std::size_t most_rows = 100000;

/// Positions of the columns.
struct Columns {
  std::size_t count = 0;
  std::size_t period = 0;
  std::size_t acceleration = 0;
  double unit = 1.0; ///< of the acceleration, m/s2
};

Columns columns(const Lines& lines) {
  std::string header = lines.text();
  std::erase(header, '#');
  const auto names = words(header);
  const auto place = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
      return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
  };
  const auto period = place("period");
  const auto si = place("acceleration");
  const auto in_g = place("acceleration_g");
  if (!period || !(si || in_g))
    lines.refuse(
        "the header of a target spectrum names the columns 'period' (s) and 'acceleration' (m/s2) or "
        "'acceleration_g'");
  return {names.size(), *period, si ? *si : *in_g, si ? 1.0 : standard_gravity};
}

} // namespace

TargetSpectrum parse_spectrum(std::istream& stream, const std::filesystem::path& file) {
  Lines lines(stream, file);
  std::optional<Columns> at;
  TargetSpectrum target;
  while (lines.next()) {
    const auto cells = words(lines.text());
    if (cells.empty())
      continue;
    if (!at) {
      at = columns(lines);
      continue;
    }
    if (cells.size() != at->count)
      lines.refuse(fmt::format("{} columns, the header has {}", cells.size(), at->count));
    const auto period = number(cells[at->period]);
    const auto acceleration = number(cells[at->acceleration]);
    if (!period || !acceleration)
      lines.refuse(fmt::format("'{}' is not a finite number",
                               shown(period ? cells[at->acceleration] : cells[at->period])));
    if (!(*period > (target.periods.empty() ? 0.0 : target.periods.back())))
      lines.refuse(fmt::format("period {} s, must be > 0 and above that of the row before", *period));
    if (!(*acceleration > 0.0))
      lines.refuse(fmt::format("acceleration {}, must be > 0", *acceleration));
    if (target.periods.size() == most_rows)
      lines.refuse(fmt::format("more than {} rows", most_rows));
    target.periods.push_back(*period);
    target.acceleration.push_back(*acceleration * at->unit);
  }
  if (target.periods.size() < 2)
    lines.refuse("a target spectrum needs at least two periods");
  return target;
}

TargetSpectrum read_spectrum(const std::filesystem::path& file) {
  if (const auto why = why_unreadable(file); !why.empty())
    throw RecordError(fmt::format("{}: {}", file.string(), why));
  std::ifstream stream(file, std::ios::binary);
  return parse_spectrum(stream, file);
}

} // namespace tremolo::motion
