// CSMIP volume 1 as it was, and RENADIC after it: 13 lines of text, 100 integers, 50 reals, then pairs of
// time and acceleration in g/10, ten fields of 7 characters a line. Channels end with "/&".

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::motion {

namespace {

constexpr ScaledUnit tenth_of_g = {Unit::g, 0.1};

Trace channel(Lines& lines) {
  Trace trace{.stated = stated(tenth_of_g), .baseline = "not corrected"};
  double count = 0.0;
  bool unit = false;
  while (!begins(trimmed(lines.text()), "RMS ACCEL")) {
    if (begins(lines.text(), "CHAN "))
      trace.component = squeezed(lines.text().substr(0, lines.text().find("(STA")));
    if (const auto points = number_after(lines.text(), "NO. OF POINTS"))
      count = points->value;
    unit = unit || says(lines.text(), "SEC AND G/10");
    if (const auto largest = number_after(lines.text(), "MAX "); unit && largest)
      trace.peak = {*largest, {Unit::g}};
    if (!lines.next())
      lines.refuse("the file ends in a header");
  }
  if (!unit || !(count >= 2.0 && count <= most_samples) || count != std::floor(count))
    lines.refuse(fmt::format("{} points, must be a whole number from 2 to {:g}, with UNITS ... SEC AND G/10",
                             count, most_samples));
  trace.line = lines.number();
  fixed_fields(lines, 5, 100);
  fixed_fields(lines, 10, 50);
  constexpr std::size_t width = 7;
  const auto pairs = fixed_fields(lines, width, 2 * static_cast<std::size_t>(count));
  std::vector<double> times;
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    times.push_back(pairs[i]);
    trace.samples.push_back(pairs[i + 1]);
  }
  const std::vector<std::size_t> line_of(times.size(), lines.number());
  trace.dt = common_step(times, line_of, lines.file());
  return trace;
}

} // namespace

std::vector<Trace> read_csmip_pairs(Lines& lines, const ReadAs&) {
  std::vector<Trace> traces;
  while (lines.next()) {
    const std::string_view line = trimmed(lines.text());
    if (begins(line, "UNCORRECTED ACCELEROGRAM DATA"))
      traces.push_back(channel(lines));
    else if (!line.empty() && !line.starts_with("/&"))
      lines.refuse(fmt::format("'{}' stands behind the points that the header announces", shown(line)));
  }
  if (traces.empty())
    lines.refuse("no header of CSMIP volume 1");
  return traces;
}

} // namespace tremolo::motion
