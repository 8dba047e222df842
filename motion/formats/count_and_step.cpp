// Texts of a title, a line with the number of samples and the step in s ("4684 0.0100", or the other way
// round), and the samples. Such a text rarely names its unit.

#include "motion/formats/formats.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::motion {

namespace {

/// A title need not speak of the samples; a line that names a quantity does.
bool speaks_of_quantity(std::string_view line) {
  constexpr std::array<std::string_view, 3> begins_of_names = {"ACC", "VEL", "DISP"};
  return std::ranges::any_of(begins_of_names, [&](auto name) { return says(line, name); });
}

} // namespace

std::optional<PeerHeader> count_and_step(std::string_view line) {
  const auto both = words(line);
  if (both.size() != 2)
    return std::nullopt;
  const auto a = number(both[0]);
  const auto b = number(both[1]);
  if (!a || !b)
    return std::nullopt;
  const auto is_count = [](double value) {
    return value >= 2.0 && value <= most_samples && value == std::floor(value);
  };
  const auto is_step = [](double value) { return value >= finest_step && value < 1.0; };
  if (is_count(*a) && is_step(*b))
    return PeerHeader{*a, *b};
  if (is_count(*b) && is_step(*a))
    return PeerHeader{*b, *a};
  return std::nullopt;
}

std::vector<Trace> read_count_and_step(Lines& lines, const ReadAs&) {
  Trace trace;
  std::optional<PeerHeader> header;
  while (!header && lines.next()) {
    header = count_and_step(lines.text());
    if (header)
      break;
    if (Stated own = stated_in_peer(lines.text()); own.unit || !own.strange.empty())
      trace.stated = std::move(own);
    else if (speaks_of_quantity(lines.text()))
      trace.stated = stated_in(lines.text());
  }
  if (!header)
    lines.refuse("no line with a count and a step");
  trace.dt = header->dt;
  trace.line = lines.number();
  read_samples(lines, static_cast<std::size_t>(header->count), trace.samples);
  return {std::move(trace)};
}

} // namespace tremolo::motion
