// ESM and ITACA, DYNA 1.x: lines "NAME: value", of which SAMPLING_INTERVAL_S, NDATA, UNITS, STREAM (or
// COMPONENT), PGA_..., BASELINE_CORRECTION, FILTER_TYPE and DATA_TYPE speak of the samples, then the samples.
// https://esm-db.eu

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace tremolo::motion {

namespace {

/// A line of the header begins with its name in capitals.
bool is_header(std::string_view line) {
  const auto colon = line.find(':');
  return colon != std::string_view::npos && std::isupper(static_cast<unsigned char>(line.front())) != 0;
}

} // namespace

std::vector<Trace> read_dyna(Lines& lines, const ReadAs&) {
  Trace trace;
  double count = 0.0;
  std::optional<Printed> peak;
  std::string filter;
  std::string type;
  std::vector<std::string> user;
  while (lines.next()) {
    const std::string_view line = trimmed(lines.text());
    if (line.empty())
      continue;
    if (!is_header(line)) {
      const auto value = number(line);
      if (!value && trace.samples.empty())
        lines.refuse(fmt::format("'{}' is neither a line of the header nor a sample", shown(line)));
      for (const auto word : words(line)) {
        const auto sample = number(word);
        if (!sample)
          lines.refuse(fmt::format("'{}' is not a finite number", shown(word)));
        if (static_cast<double>(trace.samples.size()) >= count)
          lines.refuse(fmt::format("the header says NDATA: {} but there are more samples", count));
        trace.samples.push_back(*sample);
      }
      continue;
    }
    if (!trace.samples.empty())
      lines.refuse("a line of a header among the samples");
    const auto text = std::string(trimmed(line.substr(line.find(':') + 1)));
    trace.line = lines.number();
    if (begins(line, "NDATA:"))
      count = number(text).value_or(0.0);
    else if (begins(line, "SAMPLING_INTERVAL_S:"))
      trace.dt = number(text).value_or(0.0);
    else if (begins(line, "UNITS:"))
      trace.stated = stated_in_peer(line);
    else if (begins(line, "STREAM:") || begins(line, "COMPONENT:"))
      trace.component = text;
    else if (begins(line, "PGA_") || begins(line, "PGV_") || begins(line, "PGD_"))
      peak = number_after(line, ":");
    else if (begins(line, "BASELINE_CORRECTION:"))
      trace.baseline = text;
    else if (begins(line, "FILTER_TYPE:"))
      filter = text;
    else if (begins(line, "LOW_CUT_FREQUENCY_HZ:") || begins(line, "HIGH_CUT_FREQUENCY_HZ:"))
      filter += fmt::format(" {}", text);
    else if (begins(line, "DATA_TYPE:"))
      type = text;
  }
  if (!(count >= 2.0 && count <= most_samples) || static_cast<double>(trace.samples.size()) != count)
    lines.refuse(
        fmt::format("the header says NDATA: {} but there are {} samples", count, trace.samples.size()));
  if (!filter.empty())
    trace.baseline += fmt::format("{}filter {}", trace.baseline.empty() ? "" : "; ", filter);
  if (peak && trace.stated.unit)
    trace.peak = {*peak, *trace.stated.unit};
  const Stated named = stated_in(type);
  if (named.quantity && trace.stated.quantity && *named.quantity != *trace.stated.quantity)
    lines.refuse(
        fmt::format("DATA_TYPE: {}, but UNITS are those of {}", shown(type), name(*trace.stated.quantity)));
  return {std::move(trace)};
}

} // namespace tremolo::motion
