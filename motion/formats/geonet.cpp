// GeoNet V2A (New Zealand): for each component 16 lines of text, 4 lines of 10 integers, 6 lines of 10 reals,
// then acceleration, velocity and displacement in fields of 8 characters. Integers 34 to 36 are their numbers
// of samples. https://www.geonet.org.nz/data/supplementary/strong_motion_file_formats

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace tremolo::motion {

namespace {

struct Header {
  std::string component;
  std::string baseline = "corrected by the network";
  double count = 0.0;
  double dt = 0.0;
  std::array<std::optional<StatedPeak>, 3> peaks;
};

/// "Acceleration:  peak  -9733.1 mm/s/s at  44.88 sec     rms    719.0 mm/s/s"
std::optional<StatedPeak> peak_in(std::string_view line) {
  const auto value = number_after(line, "PEAK");
  const auto text = after(line, "PEAK");
  const auto at = upper(*text).find(" AT ");
  if (!value || at == std::string::npos)
    return std::nullopt;
  const auto both = trimmed(text->substr(0, at));
  const auto unit = scaled_unit(both.substr(std::min(both.find_last_of(' ') + 1, both.size())));
  return unit ? std::optional(StatedPeak{*value, *unit}) : std::nullopt;
}

Header header(Lines& lines) {
  constexpr std::array<std::string_view, 3> quantities = {"ACCELERATION:", "VELOCITY:", "DISPLACEMENT:"};
  constexpr std::size_t lines_of_text = 16;
  Header found;
  for (std::size_t i = 1; i <= lines_of_text; ++i) {
    const std::string& line = lines.text();
    if (const auto points = number_after(line, "NUMBER OF POINTS"))
      found.count = points->value;
    if (const auto step = number_after(line, "CORRECTED DATA AT"))
      found.dt = step->value;
    if (begins(line, "BAND-PASS"))
      found.baseline = trimmed(line);
    if (const auto component = after(line, "COMPONENT "); component && begins(line, "COMPONENT"))
      found.component = trimmed(component->substr(0, component->find("  ")));
    for (std::size_t k = 0; k < quantities.size(); ++k)
      if (begins(line, quantities[k]) && says(line, "PEAK"))
        found.peaks[k] = peak_in(line);
    if (i < lines_of_text && !lines.next())
      lines.refuse("the file ends in a header");
  }
  return found;
}

void read_component(Lines& lines, std::vector<Trace>& traces) {
  const Header found = header(lines);
  const auto integers = fixed_fields(lines, 8, 40);
  fixed_fields(lines, 8, 60);
  if (integers[33] != found.count)
    lines.refuse(
        fmt::format("{} points in the text of the header, {} in its numbers", found.count, integers[33]));
  for (std::size_t k = 0; k < found.peaks.size(); ++k) {
    const double count = integers[33 + k];
    if (count == 0.0)
      continue;
    if (!(count >= 2.0 && count <= most_samples) || count != std::floor(count))
      lines.refuse(fmt::format("{} points, must be a whole number from 2 to {:g}", count, most_samples));
    if (!found.peaks[k] || static_cast<std::size_t>(quantity_of(found.peaks[k]->unit.unit)) != k)
      lines.refuse("no line of the header has the peak with its unit");
    Trace trace{.component = found.component,
                .stated = stated(found.peaks[k]->unit),
                .dt = found.dt,
                .baseline = found.baseline,
                .peak = found.peaks[k],
                .line = lines.number()};
    trace.samples = fixed_fields(lines, 8, static_cast<std::size_t>(count));
    traces.push_back(std::move(trace));
  }
}

} // namespace

std::vector<Trace> read_geonet(Lines& lines, const ReadAs&) {
  std::vector<Trace> traces;
  while (lines.next()) {
    if (begins(lines.text(), "CORRECTED ACCELEROGRAM"))
      read_component(lines, traces);
    else if (!trimmed(lines.text()).empty())
      lines.refuse(fmt::format("'{}' stands behind the points that the header announces",
                               shown(trimmed(lines.text()))));
  }
  if (traces.empty())
    lines.refuse("no samples");
  return traces;
}

} // namespace tremolo::motion
