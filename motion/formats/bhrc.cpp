// BHRC volume 1 (Iran): for each component some lines of text, 88 integers, 50 reals, then samples in g/10,
// all in fixed fields, and "/&". Real 7 is the sampling rate, Hz.

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::motion {

namespace {

constexpr ScaledUnit tenth_of_g = {Unit::g, 0.1};

Trace component(Lines& lines) {
  Trace trace{.stated = stated(tenth_of_g), .baseline = "not corrected"};
  double count = 0.0;
  double duration = 0.0;
  while (!says(lines.text(), "UNITS ARE")) {
    if (begins(lines.text(), "COMP "))
      trace.component = trimmed(*after(lines.text(), "COMP "));
    if (const auto points = number_after(lines.text(), "NO. OF POINTS"))
      count = points->value;
    if (const auto time = number_after(lines.text(), "DURATION"))
      duration = time->value;
    if (!lines.next())
      lines.refuse("the file ends in a header");
  }
  if (!says(lines.text(), "SECONDS AND G/10"))
    lines.refuse(fmt::format("'{}', read are SECONDS AND G/10", shown(trimmed(lines.text()))));
  if (!(count >= 2.0 && count <= most_samples) || count != std::floor(count))
    lines.refuse(fmt::format("{} points, must be a whole number from 2 to {:g}", count, most_samples));
  trace.line = lines.number();
  fixed_fields(lines, 5, 88);
  constexpr std::size_t width = 13;
  constexpr int lines_of_reals = 7;
  double rate = 0.0;
  for (int i = 0; i < lines_of_reals; ++i) {
    if (!lines.next())
      lines.refuse("the file ends in a header");
    if (i == 1)
      rate = number(trimmed(std::string_view(lines.text()).substr(0, width))).value_or(0.0);
  }
  if (!(rate > 0.0) || std::abs(count / rate - duration) > 1.5 / rate + 1e-3)
    lines.refuse(fmt::format("{} points at {} Hz do not last {} s", count, rate, duration));
  trace.dt = 1.0 / rate;
  trace.samples = fixed_fields(lines, width, static_cast<std::size_t>(count));
  return trace;
}

} // namespace

std::vector<Trace> read_bhrc(Lines& lines, const ReadAs&) {
  std::vector<Trace> traces;
  while (lines.next()) {
    const std::string_view line = trimmed(lines.text());
    if (begins(line, "* VOL1DS"))
      traces.push_back(component(lines));
    else if (!line.empty() && !line.starts_with("/&"))
      lines.refuse(fmt::format("'{}' stands behind the points that the header announces", shown(line)));
  }
  return traces;
}

} // namespace tremolo::motion
