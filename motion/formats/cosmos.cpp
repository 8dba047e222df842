// COSMOS V1, V2 and V2c (Strong Motion Data Format 1.20): 13 lines of text, 100 integers and 100 reals with
// their formats, comments, then "42000 acceleration pts, approx  210 secs, units=cm/sec2(04),
// Format=(1E15.6)" and the samples. Real 62 is the step in ms, 64 the largest sample. Several channels stand
// one after the other. https://www.strongmotioncenter.org/vdc/cosmos_format_1_20.pdf

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::motion {

namespace {

void next(Lines& lines) {
  if (!lines.next())
    lines.refuse("the file ends in a header");
}

/// The numbers that a line such as "100 Real-header values follow on  20 lines, Format= (5F15.6)" announces.
std::vector<double> announced(Lines& lines) {
  constexpr double fewest = 64.0;
  constexpr double most = 1000.0;
  const auto count = number_after(lines.text(), "");
  const auto format = after(lines.text(), "FORMAT");
  const auto width = format ? field_width(*format) : std::nullopt;
  if (!count || !width || !(count->value >= fewest && count->value <= most))
    lines.refuse("no number of header values with their Format");
  return fixed_fields(lines, *width, static_cast<std::size_t>(count->value));
}

Stated stated_in_section(const Lines& lines) {
  const auto units = after(lines.text(), "UNITS=");
  const auto text = units ? trimmed(units->substr(0, units->find_first_of("(,"))) : std::string_view();
  const auto unit = scaled_unit(text);
  if (unit)
    return stated(*unit);
  if (says(text, "COUNT") || says(lines.text(), "COUNTS"))
    lines.refuse("raw counts of the instrument: take the corrected file (V1 in g, or V2) of the same record");
  lines.refuse(fmt::format("'{}' is no unit that is known", shown(text)));
}

/// "1: 340 deg" from what follows "Sta Cha" in "Sta Cha:  1: 340 deg (Rcrdr Chan  1) Location: ...".
std::string station_channel(std::string_view text) {
  text = text.substr(0, text.find('('));
  text.remove_prefix(std::min(text.find_first_not_of("nN: "), text.size()));
  return squeezed(text);
}

Trace channel(Lines& lines) {
  Trace trace;
  trace.baseline = begins(lines.text(), "CORRECTED") ? "corrected by the network" : "not corrected";
  std::string name;
  while (!says(lines.text(), "INTEGER-HEADER")) {
    if (const auto sta = after(lines.text(), "STA CHA"))
      name = station_channel(*sta);
    if (const auto filter = after(lines.text(), "RECORD "); begins(lines.text(), "RECORD FILTERED"))
      trace.baseline += fmt::format(", {}", squeezed(*filter));
    next(lines);
  }
  announced(lines);
  next(lines);
  const auto reals = announced(lines);
  do
    next(lines);
  while (!says(lines.text(), "UNITS=") || trimmed(lines.text()).starts_with('|'));
  trace.stated = stated_in_section(lines);
  const auto count = number_after(lines.text(), "");
  const auto width = field_width(*after(lines.text(), "UNITS="));
  if (!count || !width || !(count->value >= 2.0 && count->value <= most_samples))
    lines.refuse("no number of points with their Format");
  trace.dt = 1e-3 * reals[61];
  const double length = reals[62];
  if (!(trace.dt > 0.0) || std::abs(count->value * trace.dt - length) > 0.01 * length + trace.dt)
    lines.refuse(fmt::format("{} points every {} s are not the length of {} s in the header", count->value,
                             trace.dt, length));
  constexpr double unknown = -999.0;
  if (reals[63] != unknown)
    trace.peak = {{reals[63], 0.0}, *trace.stated.unit};
  trace.line = lines.number();
  trace.samples = fixed_fields(lines, *width, static_cast<std::size_t>(count->value));
  trace.component = name;
  return trace;
}

} // namespace

std::vector<Trace> read_cosmos(Lines& lines, const ReadAs&) {
  std::vector<Trace> traces;
  while (lines.next()) {
    const std::string_view line = trimmed(lines.text());
    if (says(line, "(FORMAT V"))
      traces.push_back(channel(lines));
    else if (const auto channel = after(line, "END-OF-DATA FOR"); channel && !traces.empty())
      traces.back().component += fmt::format("{}{}", traces.back().component.empty() ? "" : ", ",
                                             trimmed(*channel).substr(0, trimmed(*channel).find(' ')));
    else if (!line.empty() && !line.starts_with("/&"))
      lines.refuse(fmt::format("'{}' stands behind the samples that the header announces", shown(line)));
  }
  if (traces.empty())
    lines.refuse("no header of COSMOS");
  return traces;
}

} // namespace tremolo::motion
