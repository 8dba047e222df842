#include "app/study/differences.hpp"

#include "app/verify/hermite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace tremolo::app {

namespace {

/// A component of a monitor's velocity over time.
struct Motion {
  std::vector<double> time, v, a;

  Motion(const results::SeriesData& series, const std::string& axis)
      : time(series.column("time")), v(series.column("v" + axis)), a(series.column("a" + axis)) {}

  /// m/s; the first and the last value hold beyond the ends.
  double velocity(double t) const {
    const auto after = std::ranges::upper_bound(time, t);
    if (after == time.begin())
      return v.front();
    if (after == time.end())
      return v.back();
    const auto i = static_cast<std::size_t>(after - time.begin());
    const double dt = time[i] - time[i - 1];
    return hermite({v[i - 1], a[i - 1]}, {v[i], a[i]}, dt, (t - time[i - 1]) / dt).value;
  }
};

} // namespace

double Squares::relative() const {
  return reference > 0.0 ? std::sqrt(difference / reference) : 0.0;
}

Squares difference_at(const std::string& monitor, const results::RunReader& run,
                      const results::RunReader& reference) {
  const results::SeriesData series = run.series("/monitors/" + monitor);
  const results::SeriesData expected = reference.series("/monitors/" + monitor);
  if (series.rows() == 0 || expected.rows() == 0)
    throw std::runtime_error(fmt::format("the monitor '{}' has no history", monitor));
  Squares squares;
  for (const std::string axis : {"x", "y"}) {
    const Motion moved(series, axis);
    const Motion r(expected, axis);
    for (std::size_t i = 0; i < r.time.size(); ++i)
      squares.add(moved.velocity(r.time[i]), r.v[i]);
  }
  return squares;
}

double difference_at_monitors(const results::RunReader& run, const results::RunReader& reference) {
  Squares all;
  for (const std::string& monitor : reference.monitors()) {
    const Squares squares = difference_at(monitor, run, reference);
    all.difference += squares.difference;
    all.reference += squares.reference;
  }
  if (!(all.reference > 0.0))
    throw std::runtime_error("the monitors of the reference are at rest throughout: nothing to compare");
  if (!std::isfinite(all.difference))
    throw std::runtime_error("a monitor's velocity is not finite: the run is unstable");
  return all.relative();
}

} // namespace tremolo::app
