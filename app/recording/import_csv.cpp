#include "app/free_field/table_text.hpp"
#include "app/recording/import_motion.hpp"
#include "base/text/unreadable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string_view>

namespace tremolo::app {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, imported_values> value_names{"vx", "vy", "sxx", "syy", "sxy"};

/// Positions of a table's columns.
struct Columns {
  std::size_t count = 0;
  std::size_t time = 0;
  std::size_t depth = 0;
  std::array<std::optional<std::size_t>, imported_values> values;
};

struct Row {
  double depth = 0.0;
  std::array<double, imported_values> values{};
};

std::optional<std::size_t> find(const std::vector<std::string_view>& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - names.begin()));
}

/// @throws std::invalid_argument saying what the header lacks
Columns columns_from(std::string_view header) {
  const auto names = split(header, ',');
  const auto time = find(names, "time");
  const auto depth = find(names, "depth") ? find(names, "depth") : find(names, "y");
  Columns columns{.count = names.size()};
  for (std::size_t i = 0; i < imported_values; ++i)
    columns.values[i] = find(names, value_names[i]);
  const auto& [vx, vy, sxx, syy, sxy] = columns.values;
  if (!time || !depth || !((vx && sxy) || (vy && syy)) || (vx && !sxy) || (vy && !syy))
    throw std::invalid_argument(fmt::format(
        "the header must name time, depth (or y) and vx with sxy, vy with syy, or all of vx, vy, sxx, "
        "syy, sxy; found '{}'",
        header));
  for (const auto name : names)
    if (name != "time" && name != "depth" && name != "y" &&
        !find({value_names.begin(), value_names.end()}, name))
      throw std::invalid_argument(fmt::format("the column '{}' is not known", name));
  columns.time = *time;
  columns.depth = *depth;
  return columns;
}

/// Rows of all files by time.
class Rows {
public:
  void read(const fs::path& file) {
    if (const auto why = why_unreadable(file); !why.empty())
      throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
    std::ifstream stream(file);
    std::optional<Columns> columns;
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
      if (trimmed(line).empty())
        continue;
      try {
        if (columns)
          add(line, *columns);
        else
          columns = columns_from(trimmed(line));
      } catch (const std::invalid_argument& error) {
        throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), number, error.what()));
      }
    }
    if (!columns)
      throw std::runtime_error(fmt::format("{}: is empty", file.string()));
    for (std::size_t i = 0; i < imported_values; ++i)
      given_[i] = given_[i] || columns->values[i].has_value();
  }

  std::map<double, std::vector<Row>>& by_time() { return by_time_; }
  bool given(std::size_t value) const { return given_[value]; }

private:
  void add(std::string_view line, const Columns& columns) {
    const auto cells = split(line, ',');
    if (cells.size() != columns.count)
      throw std::invalid_argument(fmt::format("{} values, the header has {}", cells.size(), columns.count));
    const auto number = [&](std::size_t i) {
      const auto value = finite_number(cells[i]);
      if (!value)
        throw std::invalid_argument(fmt::format("'{}' is not a finite number", cells[i]));
      return *value;
    };
    const double time = number(columns.time);
    Row row{.depth = number(columns.depth)};
    for (std::size_t i = 0; i < imported_values; ++i)
      row.values[i] = columns.values[i] ? number(*columns.values[i]) : 0.0;
    const auto [last, first_of_depth] = last_time_.try_emplace(row.depth, time);
    if (!first_of_depth && time < last->second)
      throw std::invalid_argument(
          fmt::format("time {} s at depth {} comes after {} s: the times of a depth must "
                      "increase",
                      time, row.depth, last->second));
    last->second = time;
    by_time_[time].push_back(row);
  }

  std::map<double, std::vector<Row>> by_time_;
  std::map<double, double> last_time_; ///< of each depth
  std::array<bool, imported_values> given_{};
};

/// Ascending y. Equal depths keep their order in that sense: a file that lists from the top down is turned.
void sort_upwards(std::vector<Row>& rows, bool depth_down) {
  const auto y = [&](const Row& row) { return depth_down ? -row.depth : row.depth; };
  if (y(rows.front()) > y(rows.back()))
    std::ranges::reverse(rows);
  std::ranges::stable_sort(rows, {}, y);
}

void require_depths(double time, const std::vector<Row>& rows, const ReadMotion& motion) {
  if (rows.size() != motion.depths.size())
    throw std::runtime_error(fmt::format("time {} s has {} depths, the first time {} s has {}", time,
                                         rows.size(), motion.times.front(), motion.depths.size()));
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].depth != motion.depths[k])
      throw std::runtime_error(
          fmt::format("time {} s has a depth {}, the first time {} s has {} in its place", time,
                      rows[k].depth, motion.times.front(), motion.depths[k]));
}

} // namespace

ReadMotion read_motion_csv(const std::vector<fs::path>& files, bool depth_down) {
  Rows rows;
  for (const fs::path& file : files)
    rows.read(file);
  ReadMotion motion;
  for (auto& [time, at_time] : rows.by_time()) {
    sort_upwards(at_time, depth_down);
    if (motion.times.empty())
      for (const Row& row : at_time)
        motion.depths.push_back(row.depth);
    motion.times.push_back(time);
    require_depths(time, at_time, motion);
    for (const Row& row : at_time)
      motion.values.insert(motion.values.end(), row.values.begin(), row.values.end());
  }
  if (motion.times.empty())
    throw std::runtime_error(fmt::format("{}: holds no values", files.front().string()));
  std::string absent;
  for (std::size_t i = 0; i < imported_values; ++i)
    if (!rows.given(i))
      absent += fmt::format("{}{}", absent.empty() ? "" : ", ", value_names[i]);
  if (!absent.empty())
    motion.notes.push_back(fmt::format("not given, taken as zero: {}", absent));
  return motion;
}

} // namespace tremolo::app
