#include "app/free_field/points_file.hpp"

#include "app/free_field/table_text.hpp"
#include "base/text/unreadable.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

namespace tremolo::app {
namespace {

/// More times than this are a slip of the pen in DT.
constexpr double most_times = 1e7;

/// A time that falls short of T1 by less than this part of DT is T1: decimal fractions are not exact.
constexpr double rounding = 1e-6;

bool is_header(std::string_view line) {
  return split(line, ',') == std::vector<std::string_view>{"x", "y"};
}

/// @throws std::invalid_argument saying what is wrong with the line
wavefield::Point parse_point(std::string_view line, double surface_level) {
  const auto cells = split(line, ',');
  if (cells.size() != 2)
    throw std::invalid_argument(fmt::format("2 values x,y are needed, found {}", cells.size()));
  std::array<double, 2> xy{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto value = finite_number(cells[i]);
    if (!value)
      throw std::invalid_argument(fmt::format("{} is '{}', must be a finite number", "xy"[i], cells[i]));
    xy[i] = *value;
  }
  if (xy[1] > surface_level)
    throw std::invalid_argument(
        fmt::format("y = {} m lies above the free surface at y = {} m", xy[1], surface_level));
  return {xy[0], xy[1]};
}

/// Words for a range of numbers in messages.
struct RangeWords {
  std::string_view what; ///< e.g. times
  char letter;
  std::string_view unit;
  std::string_view example;
};

struct Range {
  double start, step;
  std::size_t count;
};

/// "A0:A1:DA", both ends included where DA divides A1 - A0.
Range parse_range(std::string_view text, const RangeWords& words) {
  const auto refuse = [&](std::string_view why) {
    return std::invalid_argument(fmt::format("{} '{}': {}", words.what, text, why));
  };
  const char a = words.letter;
  const auto parts = split(text, ':');
  if (parts.size() != 3)
    throw refuse(fmt::format("must be {0}0:{0}1:D{0} in {1}, e.g. {2}", a, words.unit, words.example));
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = finite_number(parts[i]);
    if (!value)
      throw refuse(fmt::format("'{}' is not a finite number", parts[i]));
    values[i] = *value;
  }
  const auto [start, end, step] = values;
  if (step <= 0.0)
    throw refuse(fmt::format("D{} is {} {}, must be > 0", a, step, words.unit));
  if (end < start)
    throw refuse(fmt::format("{0}1 = {1} {3} lies before {0}0 = {2} {3}", a, end, start, words.unit));
  const double steps = std::floor((end - start) / step + rounding);
  if (steps >= most_times)
    throw refuse(fmt::format("{:.3g} {}, at most {:.0e} are written", steps + 1.0, words.what, most_times));
  return {start, step, static_cast<std::size_t>(steps) + 1};
}

} // namespace

std::vector<wavefield::Point> read_points(const std::filesystem::path& file, double surface_level) {
  if (const auto why = why_unreadable(file); !why.empty())
    throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
  std::ifstream stream(file);
  std::vector<wavefield::Point> points;
  std::string line;
  std::size_t number = 0;
  const auto at = [&] { return fmt::format("{}:{}", file.string(), number); };
  for (bool header_seen = false; std::getline(stream, line);) {
    ++number;
    if (trimmed(line).empty())
      continue;
    if (!header_seen) {
      if (!is_header(line))
        throw std::runtime_error(
            fmt::format("{}: the header must be 'x,y', found '{}'", at(), trimmed(line)));
      header_seen = true;
      continue;
    }
    try {
      points.push_back(parse_point(line, surface_level));
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error(fmt::format("{}: {}", at(), error.what()));
    }
  }
  if (points.empty())
    throw std::runtime_error(
        fmt::format("{}: holds no point; a header 'x,y' and one point a line are needed", file.string()));
  return points;
}

wavefield::TimeGrid parse_times(std::string_view text) {
  const Range range = parse_range(text, {"times", 'T', "s", "0:3:0.02"});
  return {range.start, range.step, range.count};
}

std::vector<double> parse_frequencies(std::string_view text) {
  const Range range = parse_range(text, {"frequencies", 'F', "Hz", "0.05:25:0.05"});
  if (range.start <= 0.0)
    throw std::invalid_argument(fmt::format("frequencies '{}': F0 is {} Hz, must be > 0", text, range.start));
  std::vector<double> frequencies;
  for (std::size_t i = 0; i < range.count; ++i)
    frequencies.push_back(range.start + static_cast<double>(i) * range.step);
  return frequencies;
}

} // namespace tremolo::app
