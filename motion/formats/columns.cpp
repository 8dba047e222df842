// Networks whose texts have a column for each component: UNAM (Mexico, archivo estandar), CWB (Taiwan), NSMN
// (Turkey). Each header names the components, the unit and the step.

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::motion {

namespace {

constexpr ScaledUnit gal = {Unit::cm_s2};

struct Columns {
  std::vector<std::string> names = {};
  std::vector<std::optional<StatedPeak>> peaks = {};
  double dt = 0.0;
  std::optional<double> count = std::nullopt; ///< of the samples, where the header says it
  std::string baseline = {};
  bool times = false; ///< in front of the components
};

/// The texts between slashes: "/N00E/N90E" has two.
std::vector<std::string> between_strokes(std::string_view text) {
  std::vector<std::string> found;
  for (auto stroke = text.find('/'); stroke != std::string_view::npos;) {
    text.remove_prefix(stroke + 1);
    stroke = text.find('/');
    found.emplace_back(trimmed(text.substr(0, stroke)));
  }
  return found;
}

std::optional<StatedPeak> peak_of(double value, double rounding) {
  return StatedPeak{{value, rounding}, gal};
}

void require_whole(const Lines& lines, const Columns& columns) {
  if (columns.names.empty() || !(columns.dt > 0.0))
    lines.refuse("the header lacks the components or the step");
}

/// The numbers of one line, in fixed fields where a width is known.
std::vector<double> numbers_of(const Lines& lines, std::size_t width) {
  std::vector<double> values;
  const auto add = [&](std::string_view text) {
    const auto value = number(text);
    if (!value)
      lines.refuse(fmt::format("'{}' is not a finite number", shown(text)));
    values.push_back(*value);
  };
  std::string_view rest = lines.text();
  if (width == 0)
    for (const auto word : words(rest))
      add(word);
  else
    for (; !trimmed(rest).empty(); rest.remove_prefix(std::min(width, rest.size())))
      add(trimmed(rest.substr(0, width)));
  return values;
}

std::vector<Trace> read_columns(Lines& lines, const Columns& columns, std::size_t width) {
  std::vector<Trace> traces;
  for (std::size_t i = 0; i < columns.names.size(); ++i)
    traces.push_back({.component = columns.names[i],
                      .stated = stated(gal),
                      .dt = columns.dt,
                      .baseline = columns.baseline,
                      .peak = i < columns.peaks.size() ? columns.peaks[i] : std::nullopt,
                      .line = lines.number()});
  const std::size_t first = columns.times ? 1 : 0;
  double count = 0.0;
  while (lines.next()) {
    const auto values = numbers_of(lines, width);
    if (values.empty())
      continue;
    if (values.size() != first + traces.size())
      lines.refuse(fmt::format("{} numbers, the header announces {}", values.size(), first + traces.size()));
    if (columns.times && std::abs(values[0] - count * columns.dt) > 0.02 * columns.dt)
      lines.refuse(fmt::format("time {} s, expected {:.6g} s", values[0], count * columns.dt));
    count += 1.0;
    if (count > most_samples)
      lines.refuse(fmt::format("more than {:g} samples", most_samples));
    for (std::size_t i = 0; i < traces.size(); ++i)
      traces[i].samples.push_back(values[first + i]);
  }
  if (count < 2.0 || count != columns.count.value_or(count))
    lines.refuse(fmt::format("{} samples, the header says {}", count, columns.count.value_or(2.0)));
  return traces;
}

/// The number that all of some texts say.
double common(const Lines& lines, const std::vector<std::string>& texts) {
  const auto first = texts.empty() ? std::nullopt : number(texts.front());
  for (const std::string& text : texts)
    if (!text.empty() && number(text) != first)
      lines.refuse(fmt::format("components that differ, '{}' and '{}', are not read", texts.front(), text));
  return first.value_or(0.0);
}

/// "(N-S) 13.200332 (E-W) 12.163827 (U-D) 9.840572"
std::optional<StatedPeak> named_peak(std::string_view text, const std::string& name) {
  const auto value = number_after(text, upper(fmt::format("({})", name)));
  return value ? peak_of(value->value, value->rounding) : std::nullopt;
}

} // namespace

std::vector<Trace> read_unam(Lines& lines, const ReadAs&) {
  Columns columns;
  std::size_t width = 0;
  bool unit = false;
  while (lines.next() && !begins(trimmed(lines.text()), "CANAL-1")) {
    const std::string_view line = lines.text();
    const auto colon = line.find(':');
    const auto text = colon == std::string_view::npos ? std::string_view() : line.substr(colon + 1);
    if (begins(line, "ORIENTACION C1-C6"))
      columns.names = between_strokes(text);
    else if (begins(line, "INTERVALO DE MUESTREO, C1-C6"))
      columns.dt = common(lines, between_strokes(text));
    else if (begins(line, "NUM. TOTAL DE MUESTRAS, C1-C6"))
      columns.count = common(lines, between_strokes(text));
    else if (begins(line, "ACEL. MAX.(GAL), C1-C6"))
      for (const std::string& one : between_strokes(text))
        columns.peaks.push_back(number(one) ? peak_of(*number(one), 0.0) : std::nullopt);
    else if (begins(line, "UNIDADES DE LOS DATOS"))
      unit = says(text, "GAL");
    else if (begins(line, "FACTOR DE DECIMACION") && number(trimmed(text)) != 1.0)
      lines.refuse(fmt::format("a factor of decimation of '{}', read is 1", shown(trimmed(text))));
    else if (begins(line, "FORMATO DATOS"))
      width = field_width(text).value_or(0);
  }
  if (!unit)
    lines.refuse("UNIDADES DE LOS DATOS are not Gal");
  require_whole(lines, columns);
  lines.next(); // the orientations, once more
  lines.next(); // a rule
  return read_columns(lines, columns, width);
}

std::vector<Trace> read_cwb(Lines& lines, const ReadAs&) {
  Columns columns{.times = true};
  bool unit = false;
  std::vector<std::pair<std::string, StatedPeak>> peaks;
  while (lines.next() && !begins(lines.text(), "#DATA:")) {
    const std::string_view line = lines.text();
    if (const auto rate = number_after(line, "#SAMPLERATE(HZ):"))
      columns.dt = 1.0 / rate->value;
    if (const auto text = after(line, "#AMPLITUDEUNIT:")) {
      unit = begins(trimmed(*text), "GAL");
      columns.baseline = says(*text, "DCOFFSET(CORR)") ? "offset removed by the network" : "";
    }
    // "#AmplitudeMAX. U:    0.658~   -0.837"
    if (const auto text = after(line, "#AMPLITUDEMAX. ")) {
      const auto high = number_after(*text, ":");
      const auto low = number_after(*text, "~");
      if (high && low)
        peaks.emplace_back(text->substr(0, 1),
                           *peak_of(std::max(std::abs(high->value), std::abs(low->value)), high->rounding));
    }
    // "#DataSequence: Time U(+); N(+); E(+)"
    if (const auto text = after(line, "#DATASEQUENCE: TIME"))
      for (const auto word : words(*text)) {
        if (!word.ends_with("(+)"))
          lines.refuse(fmt::format("'{}' is no component with its sign (+)", shown(word)));
        columns.names.emplace_back(word.substr(0, word.size() - 3));
      }
  }
  if (!unit)
    lines.refuse("the AmplitudeUnit is not gal");
  require_whole(lines, columns);
  columns.peaks.resize(columns.names.size());
  for (const auto& [name, peak] : peaks)
    for (std::size_t i = 0; i < columns.names.size(); ++i)
      if (columns.names[i] == name)
        columns.peaks[i] = peak;
  constexpr std::size_t width = 10;
  return read_columns(lines, columns, width);
}

std::vector<Trace> read_nsmn(Lines& lines, const ReadAs&) {
  Columns columns;
  std::string peaks;
  while (columns.names.empty() && lines.next()) {
    const std::string_view line = trimmed(lines.text());
    if (const auto count = number_after(line, "NUMBER OF DATA"))
      columns.count = count->value;
    if (const auto step = number_after(line, "SAMPLING INTERVAL (SEC)"))
      columns.dt = step->value;
    if (begins(line, "RAW PGA VALUES (GAL)"))
      peaks = line;
    if (begins(line, "N-S "))
      for (const auto word : words(line))
        columns.names.emplace_back(word);
  }
  if (peaks.empty())
    lines.refuse("no RAW PGA VALUES (gal), which name the unit");
  require_whole(lines, columns);
  for (const std::string& name : columns.names)
    columns.peaks.push_back(named_peak(peaks, name));
  return read_columns(lines, columns, 0);
}

} // namespace tremolo::motion
