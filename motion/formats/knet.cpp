// K-NET and KiK-net (NIED): a header of lines "name  value", then integers, eight a line. Acceleration is the
// integer times the scale factor "2940(gal)/6170270" less the mean of the record: the instruments have an
// offset, and the header's largest acceleration is that without it.
// https://www.kyoshin.bosai.go.jp/kyoshin/man/knetform_en.html

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>

namespace tremolo::motion {

namespace {

constexpr ScaledUnit gal = {Unit::cm_s2};

/// gal per count from "2940(gal)/6170270".
double scale_of(const Lines& lines) {
  const auto text = *after(lines.text(), "SCALE FACTOR");
  const auto unit = text.find("(gal)/");
  const auto full = number(trimmed(text.substr(0, unit)));
  const auto counts = unit == std::string_view::npos ? std::nullopt : number(trimmed(text.substr(unit + 6)));
  if (!full || !counts || !(*full > 0.0) || !(*counts > 0.0))
    lines.refuse(fmt::format("'{}' is no scale factor such as 2940(gal)/6170270", shown(trimmed(text))));
  return *full / *counts;
}

/// K-NET writes "E-W"; KiK-net numbers the sensors of the borehole and then those of the surface.
std::string direction(std::string_view text) {
  constexpr std::array<const char*, 6> of_kiknet = {"N-S in the borehole", "E-W in the borehole",
                                                    "U-D in the borehole", "N-S at the surface",
                                                    "E-W at the surface",  "U-D at the surface"};
  if (text.size() == 1 && text[0] >= '1' && text[0] <= '6')
    return of_kiknet[static_cast<std::size_t>(text[0] - '1')];
  return std::string(text);
}

} // namespace

std::vector<Trace> read_knet(Lines& lines, const ReadAs&) {
  Trace trace{.stated = stated(gal)};
  double scale = 0.0;
  double duration = 0.0;
  std::optional<Printed> frequency;
  bool header = true;
  while (header && lines.next()) {
    const std::string& line = lines.text();
    if (begins(line, "SAMPLING FREQ"))
      frequency = number_after(line, "SAMPLING FREQ");
    else if (begins(line, "DURATION TIME"))
      duration = number_after(line, "DURATION TIME").value_or(Printed{}).value;
    else if (begins(line, "DIR."))
      trace.component = direction(trimmed(*after(line, "DIR.")));
    else if (begins(line, "SCALE FACTOR"))
      scale = scale_of(lines);
    else if (const auto largest = number_after(line, "MAX. ACC."))
      trace.peak = {*largest, gal};
    header = !begins(line, "MEMO");
  }
  if (header || scale == 0.0 || !frequency || !(frequency->value > 0.0))
    lines.refuse("no header of K-NET with Sampling Freq, Scale Factor and Memo");
  trace.dt = 1.0 / frequency->value;
  trace.line = lines.number();
  while (lines.next())
    for (const auto word : words(lines.text())) {
      const auto count = number(word);
      if (!count)
        lines.refuse(fmt::format("'{}' is not a finite number", shown(word)));
      if (static_cast<double>(trace.samples.size()) >= most_samples)
        lines.refuse(fmt::format("more than {:g} samples", most_samples));
      trace.samples.push_back(*count * scale);
    }
  const auto count = static_cast<double>(trace.samples.size());
  const double missing = duration - count * trace.dt;
  const std::string contradiction =
      fmt::format("{} samples every {} s, but the header says a duration of {} s", trace.samples.size(),
                  trace.dt, duration);
  if (count < 2.0 || std::abs(missing) > 1.0)
    lines.refuse(contradiction);
  if (std::abs(missing) > 0.5 * trace.dt)
    trace.doubt = contradiction;
  const double mean = std::accumulate(trace.samples.begin(), trace.samples.end(), 0.0) / count;
  for (double& sample : trace.samples)
    sample -= mean;
  trace.baseline = fmt::format("mean of {:.4g} cm/s2 removed on reading", mean);
  return {std::move(trace)};
}

} // namespace tremolo::motion
