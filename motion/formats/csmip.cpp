// CSMIP volumes 1 and 2 and USC volume 2: a header of text, integers and reals, then a section for each
// quantity, "3251 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)", in fields of 10
// characters unless the line has a format "(8f10.6)". Channels stand one after the other.
// Shakal & Huang, Standard tape format for CSMIP strong-motion data tapes, CDMG OSMS 85-03.

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <array>

namespace tremolo::motion {

namespace {

/// A header's statements about its channel.
struct Channel {
  std::string name;
  std::string baseline;
  std::array<std::optional<StatedPeak>, 3> peaks; ///< of acceleration, velocity, displacement
};

bool is_section(std::string_view line) {
  return says(line, "POINTS OF ") && says(line, "EQUALLY SPACED AT");
}

/// "PEAK   VELOCITY   =    12.05681    CMS/SEC   AT    4.500   SEC."
std::optional<StatedPeak> peak_in(std::string_view line, std::string_view quantity) {
  const auto behind = begins(trimmed(line), "PEAK") ? after(line, quantity) : std::nullopt;
  const auto value = behind ? number_after(*behind, "") : std::nullopt;
  const auto at = behind ? upper(*behind).find(" AT ") : std::string::npos;
  if (!value || at == std::string::npos)
    return std::nullopt;
  const auto text = trimmed(behind->substr(0, at));
  const auto unit = scaled_unit(text.substr(std::min(text.find_last_of(" \t") + 1, text.size())));
  return unit ? std::optional(StatedPeak{*value, *unit}) : std::nullopt;
}

void read_text(std::string_view line, Channel& channel) {
  constexpr std::array<std::string_view, 3> quantities = {"ACCELERATION", "VELOCITY", "DISPLACEMENT"};
  if (begins(line, "CHAN ") || begins(line, "COMP "))
    channel.name = squeezed(line.substr(0, line.find("    ")));
  for (std::size_t i = 0; i < quantities.size(); ++i)
    if (const auto peak = peak_in(line, quantities[i]))
      channel.peaks[i] = peak;
  if (says(line, "FILTERED"))
    channel.baseline = squeezed(line);
  else if (says(line, "BASELINE-CORRECTED") || says(line, "BASELINE CORRECTED"))
    channel.baseline +=
        fmt::format("{}baseline-corrected by the network", channel.baseline.empty() ? "" : "; ");
}

/// The text that names the unit: "(UNITS: CM/SEC)", "in cm/sec2. (8f10.6)", "IN UNITS CM/SEC/SEC".
std::string_view unit_text(std::string_view line) {
  std::string_view text = after(line, "EQUALLY SPACED AT").value_or("");
  for (const char* key : {" IN ", "UNITS", ":"})
    text = after(text, key).value_or(text);
  return trimmed(text.substr(0, text.find_first_of("().")));
}

Trace section(Lines& lines, const Channel& channel) {
  const std::string line = lines.text();
  const auto count = number_after(line, "");
  const auto step = number_after(line, "EQUALLY SPACED AT");
  const auto unit = scaled_unit(unit_text(line));
  if (!count || !(count->value >= 2.0 && count->value <= most_samples) || !step)
    lines.refuse("no number of points with their spacing");
  if (!unit)
    lines.refuse(fmt::format("'{}' is no unit that is known", shown(unit_text(line))));
  Trace trace{.component = channel.name, .stated = stated(*unit), .dt = step->value};
  const auto quantity = *trace.stated.quantity;
  constexpr std::array<std::string_view, 3> words_of = {"POINTS OF ACC", "POINTS OF VEL", "POINTS OF DIS"};
  if (!says(line, words_of[static_cast<std::size_t>(quantity)]))
    lines.refuse(fmt::format("{} is no unit of what the line announces", name(*unit)));
  trace.peak = channel.peaks[static_cast<std::size_t>(quantity)];
  trace.baseline = channel.baseline;
  trace.line = lines.number();
  constexpr std::size_t usual_width = 10;
  trace.samples = fixed_fields(lines, field_width(*after(line, "EQUALLY SPACED AT")).value_or(usual_width),
                               static_cast<std::size_t>(count->value));
  return trace;
}

} // namespace

std::vector<Trace> read_csmip(Lines& lines, const ReadAs&) {
  std::vector<Trace> traces;
  Channel channel;
  bool in_sections = false;
  while (lines.next()) {
    const std::string_view line = trimmed(lines.text());
    const bool ends = line.starts_with("/&");
    if (is_section(line)) {
      traces.push_back(section(lines, channel));
      in_sections = true;
    } else if (ends || says(line, "CORRECTED ACCELEROGRAM ")) {
      channel = {};
      in_sections = false;
    } else if (in_sections && !line.empty()) {
      lines.refuse(fmt::format("'{}' stands behind the points that the header announces", shown(line)));
    } else {
      read_text(line, channel);
    }
  }
  if (traces.empty())
    lines.refuse("no section of points");
  return traces;
}

} // namespace tremolo::motion
