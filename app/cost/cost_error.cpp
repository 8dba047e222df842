#include "app/cost/cost_error.hpp"

#include "app/verify/hermite.hpp"
#include "app/verify/particle_agreement.hpp"
#include "app/verify/verification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::app {

namespace {

/// A component of a monitor's velocity and its acceleration over time.
class Motion {
public:
  Motion(const results::SeriesData& series, const std::string& axis)
      : time_(column(series, "time")), v_(column(series, "v" + axis)), a_(column(series, "a" + axis)) {}

  const std::vector<double>& times() const { return time_; }
  const std::vector<double>& velocities() const { return v_; }

  /// m/s; the first and the last value hold beyond the ends.
  double velocity(double t) const {
    const auto after = std::ranges::upper_bound(time_, t);
    if (after == time_.begin())
      return v_.front();
    if (after == time_.end())
      return v_.back();
    const auto i = static_cast<std::size_t>(after - time_.begin());
    const double dt = time_[i] - time_[i - 1];
    return hermite({v_[i - 1], a_[i - 1]}, {v_[i], a_[i]}, dt, (t - time_[i - 1]) / dt).value;
  }

private:
  static std::vector<double> column(const results::SeriesData& series, const std::string& name) {
    const auto found = std::ranges::find(series.columns, name);
    if (found == series.columns.end())
      throw std::runtime_error(fmt::format("a monitor has no column '{}'", name));
    std::vector<double> values;
    for (auto i = static_cast<std::size_t>(found - series.columns.begin()); i < series.values.size();
         i += series.columns.size())
      values.push_back(series.values[i]);
    return values;
  }

  std::vector<double> time_, v_, a_;
};

} // namespace

RunError error_to_exact(const results::RunReader& run, const scene::Case& scene) {
  const Agreement whole = verify(run, scene).particles.regions.front();
  return {whole.relative_l2, whole.phase_lag};
}

RunError error_to_run(const results::RunReader& run, const results::RunReader& reference) {
  double difference2 = 0.0;
  double reference2 = 0.0;
  for (const std::string& monitor : reference.monitors()) {
    const results::SeriesData series = run.series("/monitors/" + monitor);
    const results::SeriesData expected = reference.series("/monitors/" + monitor);
    if (series.rows() == 0 || expected.rows() == 0)
      throw std::runtime_error(fmt::format("the monitor '{}' has no history", monitor));
    for (const std::string axis : {"x", "y"}) {
      const Motion moved(series, axis);
      const Motion r(expected, axis);
      for (std::size_t i = 0; i < r.times().size(); ++i) {
        const double error = moved.velocity(r.times()[i]) - r.velocities()[i];
        difference2 += error * error;
        reference2 += r.velocities()[i] * r.velocities()[i];
      }
    }
  }
  if (!(reference2 > 0.0))
    throw std::runtime_error("the monitors of the reference are at rest throughout: nothing to compare");
  if (!std::isfinite(difference2))
    throw std::runtime_error("a monitor's velocity is not finite: the run is unstable");
  return {std::sqrt(difference2 / reference2), 0.0};
}

} // namespace tremolo::app
