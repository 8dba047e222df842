#include "results/paraview/shapes.hpp"

#include "base/vector.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>
#include <utility>

namespace tremolo::results {
namespace {

/// Numbers of a series by column.
class Columns {
public:
  Columns(const FileReader& run, const std::string& path)
      : names_(run.attribute_as<std::vector<std::string>>(path, "columns")),
        values_(run.numbers<double>(run.dataset(path).get(), H5T_NATIVE_DOUBLE, path)) {
    const auto all = std::views::iota(std::size_t{0}, values_.size() / names_.size());
    const auto unwritten =
        std::ranges::find_if(all, [this](std::size_t i) { return std::isnan(value(i, 0)); });
    rows_ = static_cast<std::size_t>(unwritten - all.begin());
  }

  /// A time of the series: linear between rows, held before the first and after the last.
  struct Moment {
    std::size_t before = 0; ///< row
    std::size_t after = 0;  ///< row
    double share = 0.0;     ///< of the later row, 1
  };
  Moment moment(double time) const {
    const auto later = std::views::iota(std::size_t{0}, rows_);
    const auto after =
        std::ranges::lower_bound(later, time, {}, [this](std::size_t i) { return value(i, 0); });
    if (after == later.begin())
      return {};
    if (after == later.end())
      return {rows_ - 1, rows_ - 1, 0.0};
    const std::size_t i = *after;
    return {i - 1, i, (time - value(i - 1, 0)) / (value(i, 0) - value(i - 1, 0))};
  }
  std::size_t column(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
  }
  /// A column at a time; 0 without rows.
  double at(std::size_t column, const Moment& moment) const {
    if (rows_ == 0)
      return 0.0;
    const double before = value(moment.before, column);
    return before + moment.share * (value(moment.after, column) - before);
  }
  /// Number of the datasets x0, x1, ...
  std::size_t numbered(const std::string& name) const {
    std::size_t count = 0;
    while (std::ranges::find(names_, fmt::format("{}{}", name, count)) != names_.end())
      ++count;
    return count;
  }

private:
  double value(std::size_t row, std::size_t column) const { return values_[row * names_.size() + column]; }

  std::vector<std::string> names_;
  std::vector<double> values_;
  std::size_t rows_ = 0; ///< that have a time
};

/// A line and where its points are at each time.
struct Line {
  std::int32_t part;
  bool closed;
  std::vector<std::vector<Vector>> places; ///< [time][point]; of one that stays, once
};

std::vector<Line> faces(const FileReader& run) {
  std::vector<Line> lines;
  if (!run.exists("boundary"))
    return lines;
  const auto numbers = [&](const char* name) {
    return run.numbers<double>(run.dataset(name).get(), H5T_NATIVE_DOUBLE, name);
  };
  const auto position = numbers("/boundary/position");
  const auto normal = numbers("/boundary/normal");
  const auto length = numbers("/boundary/length");
  for (std::size_t i = 0; i < length.size(); ++i) {
    const Vector half{-0.5 * length[i] * normal[2 * i + 1], 0.5 * length[i] * normal[2 * i]};
    const double x = position[2 * i];
    const double y = position[2 * i + 1];
    lines.push_back({part_of_faces, false, {{{x - half.x, y - half.y}, {x + half.x, y + half.y}}}});
  }
  return lines;
}

std::vector<Vector> corners_of(const std::vector<double>& ring) {
  std::vector<Vector> corners;
  for (std::size_t i = 0; i + 1 < ring.size(); i += 2)
    corners.push_back({ring[i], ring[i + 1]});
  return corners;
}

/// The corners of a ring of a rigid structure, which has moved and turned about its centre of mass.
Line rigid_ring(const std::vector<Vector>& corners, const Columns& motion, std::span<const double> times) {
  Line line{part_of_bodies, true, {}};
  const std::size_t x_column = motion.column("x");
  const std::size_t y_column = motion.column("y");
  const std::size_t tilt_column = motion.column("tilt");
  const Vector start{motion.at(x_column, {}), motion.at(y_column, {})};
  for (const double time : times) {
    const auto moment = motion.moment(time);
    const Vector centre{motion.at(x_column, moment), motion.at(y_column, moment)};
    const double cosine = std::cos(motion.at(tilt_column, moment));
    const double sine = std::sin(motion.at(tilt_column, moment));
    std::vector<Vector> places;
    for (const Vector& corner : corners) {
      const double x = corner.x - start.x;
      const double y = corner.y - start.y;
      places.push_back({centre.x + cosine * x - sine * y, centre.y + sine * x + cosine * y});
    }
    line.places.push_back(std::move(places));
  }
  return line;
}

/// A line whose points are pairs of columns of a series.
Line moving_line(std::int32_t part, bool closed, const Columns& series,
                 const std::vector<std::pair<std::string, std::string>>& points,
                 std::span<const double> times) {
  Line line{part, closed, {}};
  std::vector<std::pair<std::size_t, std::size_t>> columns;
  for (const auto& [x, y] : points)
    columns.emplace_back(series.column(x), series.column(y));
  for (const double time : times) {
    const auto moment = series.moment(time);
    std::vector<Vector> places;
    for (const auto& [x, y] : columns)
      places.push_back({series.at(x, moment), series.at(y, moment)});
    line.places.push_back(std::move(places));
  }
  return line;
}

/// A ring whose points are columns x0, y0, ... with a prefix: of an elastic structure, or a lining.
Line bent_ring(std::int32_t part, const Columns& series, const std::string& prefix,
               std::span<const double> times) {
  std::vector<std::pair<std::string, std::string>> points;
  for (std::size_t i = 0; i < series.numbered(prefix + "x"); ++i)
    points.emplace_back(fmt::format("{}x{}", prefix, i), fmt::format("{}y{}", prefix, i));
  return moving_line(part, true, series, points, times);
}

std::vector<Line> bodies(const FileReader& run, std::span<const double> times) {
  std::vector<Line> lines;
  if (!run.exists("bodies"))
    return lines;
  for (const std::string& name : run.children("bodies")) {
    const std::string path = "/bodies/" + name;
    if (run.exists("outlines") && run.exists("outlines/" + name)) {
      const Columns outline(run, "/outlines/" + name);
      lines.push_back(bent_ring(part_of_bodies, outline, "", times));
      if (outline.numbered("hole_x") > 0)
        lines.push_back(bent_ring(part_of_bodies, outline, "hole_", times));
      continue;
    }
    const Columns motion(run, path);
    for (const char* ring : {"outline", "hole"})
      if (run.has_attribute(path, ring))
        lines.push_back(
            rigid_ring(corners_of(run.attribute_as<std::vector<double>>(path, ring)), motion, times));
  }
  return lines;
}

std::vector<Line> linings(const FileReader& run, std::span<const double> times) {
  std::vector<Line> lines;
  if (run.exists("linings"))
    for (const std::string& name : run.children("linings"))
      lines.push_back(bent_ring(part_of_linings, Columns(run, "/linings/" + name), "", times));
  return lines;
}

std::vector<Line> props(const FileReader& run, std::span<const double> times) {
  std::vector<Line> lines;
  if (run.exists("props"))
    for (const std::string& name : run.children("props"))
      lines.push_back(moving_line(part_of_props, false, Columns(run, "/props/" + name),
                                  {{"from_x", "from_y"}, {"to_x", "to_y"}}, times));
  return lines;
}

void add(const std::vector<Vector>& places, std::vector<double>& points) {
  for (const Vector& place : places)
    points.insert(points.end(), {place.x, place.y, 0.0});
}

} // namespace

Shapes shapes_of(const FileReader& run, std::span<const double> times) {
  std::vector<Line> lines = faces(run);
  const std::size_t still = lines.size();
  for (auto* const find : {&bodies, &linings, &props})
    std::ranges::move((*find)(run, times), std::back_inserter(lines));
  Shapes shapes;
  shapes.offsets.push_back(0);
  for (const Line& line : lines) {
    const auto first = static_cast<std::int64_t>(shapes.count());
    const std::size_t count = line.places.front().size();
    for (std::size_t i = 0; i < count; ++i)
      shapes.connectivity.push_back(first + static_cast<std::int64_t>(i));
    if (line.closed && count > 0)
      shapes.connectivity.push_back(first);
    shapes.offsets.push_back(static_cast<std::int64_t>(shapes.connectivity.size()));
    shapes.parts.insert(shapes.parts.end(), count, line.part);
  }
  const std::span all(lines);
  for (const Line& line : all.first(still))
    add(line.places.front(), shapes.fixed);
  for (std::size_t k = 0; k < times.size(); ++k)
    for (const Line& line : all.subspan(still))
      add(line.places[k], shapes.moving);
  return shapes;
}

} // namespace tremolo::results
