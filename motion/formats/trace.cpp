#include "motion/formats/trace.hpp"

#include "base/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace tremolo::motion {

namespace {

/// Channels that have the same name, or none, get numbers: nothing that a file holds is out of reach.
void name_apart(std::vector<Trace>& traces) {
  std::map<std::pair<std::string, std::optional<Quantity>>, int> found;
  for (Trace& trace : traces)
    if (const int count = ++found[{trace.component, trace.stated.quantity}]; count > 1)
      trace.component = fmt::format("{} ({})", trace.component, count);
}

/// The names of the components in the order of the file.
std::vector<std::string> components(const std::vector<Trace>& traces) {
  std::vector<std::string> names;
  std::set<std::string> found;
  for (const Trace& trace : traces)
    if (found.insert(trace.component).second)
      names.push_back(trace.component);
  return names;
}

std::string component(const std::vector<std::string>& names, const std::filesystem::path& file,
                      const ReadAs& as) {
  const bool one = names.size() == 1;
  if (as.component.empty() && one)
    return names.front();
  if (as.component.empty())
    throw RecordError(fmt::format("{}: holds {} components: say which (--component): {}", file.string(),
                                  names.size(), listed(names)));
  if (const auto place = place_of(as.component, names))
    return names[*place];
  if (one && names.front().empty())
    throw RecordError(
        fmt::format("{}: holds one component without a name, not '{}'", file.string(), shown(as.component)));
  throw RecordError(fmt::format("{}: '{}' is none of its components, or several of them: {}", file.string(),
                                shown(as.component), listed(names)));
}

/// A sample that the file says is its largest, and is not.
std::optional<std::string> doubt_of_peak(const Trace& trace) {
  if (!trace.peak || !trace.stated.unit)
    return std::nullopt;
  constexpr double tolerance =
      0.01; // those who process a record print peaks of more digits, or of the raw one
  const double scale = in_si(trace.peak->unit);
  const double stated = std::abs(trace.peak->printed.value) * scale;
  const double found = peak(trace.samples) * in_si(*trace.stated.unit);
  if (std::abs(found - stated) <= tolerance * stated + trace.peak->printed.rounding * scale)
    return std::nullopt;
  return fmt::format("the file states a peak of {:g} {}, its samples have {:g}", stated / scale,
                     name(trace.peak->unit), found / scale);
}

} // namespace

Stated stated(ScaledUnit unit) {
  return {.quantity = quantity_of(unit.unit), .unit = unit};
}

std::optional<std::size_t> place_of(const std::string& asked, const std::vector<std::string>& names,
                                    std::size_t first) {
  if (const auto place = number(asked)) {
    const double last = static_cast<double>(first + names.size()) - 1.0;
    if (*place >= static_cast<double>(first) && *place <= last && *place == std::floor(*place))
      return static_cast<std::size_t>(*place) - first;
    // "360" may be an azimuth, one digit is a number.
    if (asked.size() == 1)
      return std::nullopt;
  }
  std::optional<std::size_t> part;
  bool several = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (upper(names[i]) == upper(asked))
      return i;
    if (says(names[i], upper(asked))) {
      several = part.has_value();
      part = i;
    }
  }
  return several ? std::nullopt : part;
}

std::string listed(const std::vector<std::string>& names, std::size_t first) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    text += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", first + i, shown(names[i]));
  return text + (names.size() > most ? ", ..." : "");
}

Record chosen(std::vector<Trace> traces, const std::string& format, const std::filesystem::path& file,
              const ReadAs& as, bool fallback_to_peer) {
  name_apart(traces);
  const auto names = components(traces);
  const std::string wanted = component(names, file, as);
  std::erase_if(traces, [&](const Trace& trace) { return trace.component != wanted; });
  const auto quantity = as.unit       ? std::optional(quantity_of(*as.unit))
                        : as.quantity ? as.quantity
                                      : std::optional(Quantity::acceleration);
  auto trace = std::ranges::find(traces, quantity, [](const Trace& one) { return one.stated.quantity; });
  if (trace == traces.end())
    trace = traces.begin();
  const auto doubt = doubt_of_peak(*trace);
  Record record{.dt = trace->dt, .samples = std::move(trace->samples)};
  record.origin = {.format = format,
                   .component = wanted,
                   .components = names.size(),
                   .unit = {},
                   .baseline = trace->baseline,
                   .doubts = {}};
  settle(record, stated_by_name(file), trace->stated, as, fallback_to_peer,
         fmt::format("{}:{}", file.string(), trace->line));
  if (!trace->doubt.empty())
    record.origin.doubts.push_back(trace->doubt);
  if (doubt)
    record.origin.doubts.push_back(*doubt);
  return record;
}

} // namespace tremolo::motion
