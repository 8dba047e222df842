#include "app/free_field/table_text.hpp"
#include "app/recording/import_motion.hpp"
#include "base/text/unreadable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <string_view>

namespace tremolo::app {

namespace {

namespace fs = std::filesystem;

std::ifstream opened(const fs::path& file) {
  if (const auto why = why_unreadable(file); !why.empty())
    throw std::runtime_error(fmt::format("{}: {}", file.string(), why));
  return std::ifstream(file);
}

/// A recorder's file: rows of the time and one number a column.
struct Recorder {
  fs::path file;
  std::vector<double> times;
  std::vector<std::vector<double>> rows;

  explicit Recorder(const fs::path& path) : file(path) {
    auto stream = opened(path);
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
      const auto cells = words(line);
      if (cells.empty())
        continue;
      const auto at = [&] { return fmt::format("{}:{}", path.string(), number); };
      std::vector<double> row;
      for (const auto cell : cells) {
        const auto value = finite_number(cell);
        if (!value)
          throw std::runtime_error(fmt::format("{}: '{}' is not a finite number", at(), cell));
        row.push_back(*value);
      }
      if (!rows.empty() && row.size() != rows.front().size() + 1)
        throw std::runtime_error(fmt::format("{}: {} numbers, the rows before have {}", at(), row.size(),
                                             rows.front().size() + 1));
      if (!times.empty() && row.front() <= times.back())
        throw std::runtime_error(fmt::format("{}: time {} s comes after {} s: times must increase; start the "
                                             "recorder after the static stage",
                                             at(), row.front(), times.back()));
      times.push_back(row.front());
      rows.emplace_back(row.begin() + 1, row.end());
    }
    if (rows.empty())
      throw std::runtime_error(fmt::format("{}: is empty", path.string()));
  }

  /// Columns of each of `count` nodes or elements.
  std::size_t components(std::size_t count, std::string_view what) const {
    const std::size_t columns = rows.front().size();
    if (count == 0 || columns % count != 0)
      throw std::runtime_error(
          fmt::format("{}: {} columns behind the time do not belong to the {} {} of the table "
                      "of points; the recorder needs -time",
                      file.string(), columns, count, what));
    return columns / count;
  }
};

struct Points {
  std::vector<double> nodes; ///< depths, in the order of the recorder
  std::vector<double> elements;
};

Points read_points_table(const fs::path& file) {
  auto stream = opened(file);
  Points points;
  std::string line;
  bool header = false;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (trimmed(line).empty())
      continue;
    const auto cells = split(line, ',');
    const auto refuse = [&](std::string_view why) {
      return std::runtime_error(
          fmt::format("{}:{}: {}, found '{}'", file.string(), number, why, trimmed(line)));
    };
    if (!header) {
      if (cells != std::vector<std::string_view>{"kind", "tag", "depth"})
        throw refuse("the header must be 'kind,tag,depth'");
      header = true;
      continue;
    }
    const auto depth = cells.size() == 3 ? finite_number(cells[2]) : std::nullopt;
    if (!depth || (cells[0] != "node" && cells[0] != "element"))
      throw refuse("a line must be 'node,TAG,DEPTH' or 'element,TAG,DEPTH'");
    auto& depths = cells[0] == "node" ? points.nodes : points.elements;
    if (std::ranges::find(depths, *depth) != depths.end())
      throw refuse(
          fmt::format("there is a {} at this depth already; one line of the model is enough", cells[0]));
    depths.push_back(*depth);
  }
  return points;
}

/// vx, vy of each node; a third degree of freedom, the pore pressure, is left out.
std::size_t velocity_components(const Recorder& velocities, std::size_t nodes) {
  const std::size_t components = velocities.components(nodes, "nodes");
  if (components > 3)
    throw std::runtime_error(
        fmt::format("{}: {} velocities a node; known are 1 (x), 2 (x, y) and 3 (x, y, pore "
                    "pressure)",
                    velocities.file.string(), components));
  return components;
}

/// Columns of an element's stresses: xx, yy, xy of each integration point, or xx, yy, zz, xy and perhaps one
/// number more.
struct StressColumns {
  std::size_t points = 1;
  std::size_t components = 3;
};

StressColumns stress_columns(const Recorder& stresses, std::size_t elements) {
  const std::size_t columns = stresses.components(elements, "elements");
  for (const std::size_t points : {1U, 4U})
    if (columns % points == 0 && columns / points >= 3 && columns / points <= 5)
      return {points, columns / points};
  throw std::runtime_error(
      fmt::format("{}: {} stresses an element; known are 3 (xx, yy, xy), 4 (xx, yy, zz, xy) and 5 "
                  "(and one more), at 1 or 4 integration points",
                  stresses.file.string(), columns));
}

/// xx, yy, xy of an element, the mean of its integration points.
std::array<double, 3> stress_of(const std::vector<double>& row, std::size_t element,
                                const StressColumns& columns) {
  std::array<double, 3> mean{};
  const std::size_t shear = columns.components == 3 ? 2 : 3;
  for (std::size_t point = 0; point < columns.points; ++point) {
    const double* s = row.data() + (element * columns.points + point) * columns.components;
    mean[0] += s[0];
    mean[1] += s[1];
    mean[2] += s[shear];
  }
  for (double& value : mean)
    value /= static_cast<double>(columns.points);
  return mean;
}

/// Two elements and their weights: linear in depth between centres, and beyond the last ones.
struct Interpolation {
  std::size_t first = 0, second = 0;
  double weight = 0.0; ///< of the second
};

Interpolation interpolation(const std::vector<double>& centres, const std::vector<std::size_t>& order,
                            double depth) {
  if (order.size() == 1)
    return {order[0], order[0], 0.0};
  std::size_t i = 0;
  while (i + 2 < order.size() && depth > centres[order[i + 1]])
    ++i;
  const double a = centres[order[i]];
  const double b = centres[order[i + 1]];
  return {order[i], order[i + 1], (depth - a) / (b - a)};
}

std::vector<std::size_t> ascending(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  return order;
}

void require_equal_times(const Recorder& velocities, const Recorder& stresses) {
  constexpr double rounding = 1e-5; // six digits
  const auto& t = velocities.times;
  const auto& s = stresses.times;
  for (std::size_t i = 0; i < std::max(t.size(), s.size()); ++i)
    if (i >= t.size() || i >= s.size() || std::abs(t[i] - s[i]) > rounding * std::max(std::abs(t[i]), 1e-3))
      throw std::runtime_error(fmt::format("{} and {} do not have the same times: row {} is {} and {}",
                                           velocities.file.string(), stresses.file.string(), i + 1,
                                           i < t.size() ? fmt::format("{} s", t[i]) : "missing",
                                           i < s.size() ? fmt::format("{} s", s[i]) : "missing"));
}

} // namespace

ReadMotion read_motion_opensees(const fs::path& velocity_file, const fs::path& stress_file,
                                const fs::path& point_file, bool depth_down) {
  const Points points = read_points_table(point_file);
  const Recorder velocities(velocity_file);
  const Recorder stresses(stress_file);
  require_equal_times(velocities, stresses);
  const std::size_t dofs = velocity_components(velocities, points.nodes.size());
  const StressColumns columns = stress_columns(stresses, points.elements.size());

  auto upwards = ascending(points.nodes);
  if (depth_down)
    std::ranges::reverse(upwards);
  const auto element_order = ascending(points.elements);
  ReadMotion motion{.times = velocities.times, .depths = {}, .values = {}, .notes = {}};
  std::vector<Interpolation> at_node;
  for (const std::size_t node : upwards) {
    motion.depths.push_back(points.nodes[node]);
    at_node.push_back(interpolation(points.elements, element_order, points.nodes[node]));
  }
  for (std::size_t step = 0; step < motion.times.size(); ++step)
    for (std::size_t k = 0; k < upwards.size(); ++k) {
      const double* v = velocities.rows[step].data() + upwards[k] * dofs;
      const auto below = stress_of(stresses.rows[step], at_node[k].first, columns);
      const auto above = stress_of(stresses.rows[step], at_node[k].second, columns);
      motion.values.insert(motion.values.end(), {v[0], dofs > 1 ? v[1] : 0.0});
      for (std::size_t c = 0; c < 3; ++c)
        motion.values.push_back((1.0 - at_node[k].weight) * below[c] + at_node[k].weight * above[c]);
    }
  motion.notes.push_back(fmt::format("stresses of {} elements interpolated linearly in depth to {} nodes",
                                     points.elements.size(), points.nodes.size()));
  return motion;
}

} // namespace tremolo::app
