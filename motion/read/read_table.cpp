#include "motion/read/read_formats.hpp"
#include "motion/read/stated.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::motion {

namespace {

/// Printed times are rounded; a step may differ from the mean by this part of it.
constexpr double step_tolerance = 0.02;

struct Row {
  double time;
  double value;
};

/// The name of the second column.
std::string_view value_name(std::string_view header) {
  const auto separator = header.find_first_of(",;\t");
  if (separator == std::string_view::npos)
    return header;
  header.remove_prefix(separator + 1);
  return header.substr(0, header.find_first_of(",;\t"));
}

bool is_blank(std::string_view line) {
  return words(line).empty();
}

Row row(const Lines& lines) {
  const auto cells = words(lines.text());
  if (cells.size() != 2)
    lines.refuse(fmt::format("a time and a value are needed, found {} columns", cells.size()));
  const auto time = number(cells[0]);
  const auto value = number(cells[1]);
  if (!time || !value)
    lines.refuse(fmt::format("'{}' is not a finite number", shown(time ? cells[1] : cells[0])));
  return {*time, *value};
}

/// Decimal fractions are not exact: the number of at most nine digits that is meant.
double as_printed(double dt) {
  const double digits = std::pow(10.0, 8.0 - std::floor(std::log10(dt)));
  const double rounded = std::round(dt * digits) / digits;
  return std::abs(rounded - dt) <= 1e-12 * dt ? rounded : dt;
}

double common_step(const std::vector<double>& times, const std::vector<std::size_t>& line_of,
                   const std::filesystem::path& file) {
  const double dt = times.back() / static_cast<double>(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double expected = static_cast<double>(i) * dt;
    if (std::abs(times[i] - expected) > step_tolerance * dt)
      refuse(file, line_of[i],
             fmt::format("time {} s, expected {:.6g} s: the steps must be equal, {:.6g} s on average here",
                         times[i], expected, dt));
  }
  return as_printed(dt);
}

void require_later(const Lines& lines, double time, const std::vector<double>& times) {
  constexpr double rounding = 1e-9;
  if (times.empty()) {
    if (std::abs(time) > rounding)
      lines.refuse(fmt::format("the first time is {} s, must be 0", time));
  } else if (!(time > times.back())) {
    lines.refuse(fmt::format("time {} s does not come after {} s", time, times.back()));
  }
  if (static_cast<double>(times.size()) >= most_samples)
    lines.refuse(fmt::format("more than {:g} samples", most_samples));
}

} // namespace

Record read_table(Lines& lines, const ReadAs& as) {
  Stated by_header;
  std::vector<double> times;
  std::vector<std::size_t> line_of;
  Record record;
  for (bool header_allowed = true; lines.next();) {
    const std::string& line = lines.text();
    if (is_blank(line))
      continue;
    const bool comment = line.starts_with('#');
    if (times.empty() && header_allowed && (comment || !number(words(line).front()))) {
      by_header = stated_in(value_name(line));
      header_allowed = comment && !by_header.quantity;
      continue;
    }
    if (comment)
      continue;
    const Row next = row(lines);
    require_later(lines, next.time, times);
    times.push_back(next.time);
    line_of.push_back(lines.number());
    record.samples.push_back(next.value);
  }
  if (times.size() < 2)
    lines.refuse(fmt::format("{} samples, at least 2 are needed", times.size()));
  record.dt = common_step(times, line_of, lines.file());
  settle(record, stated_by_name(lines.file()), by_header, as, false, lines.file().string() + ":1");
  return record;
}

} // namespace tremolo::motion
