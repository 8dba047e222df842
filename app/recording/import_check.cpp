// Whether an imported field can be what the user says it is.

#include "app/recording/import_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::app {

namespace {

using coupler::Direction;

/// Range for soil and rock if the user gives no density, kg/m3.
constexpr double least_density = 1000.0;
constexpr double largest_density = 3000.0;
/// Tolerance relative to a density that the user gives: finite differences over metres of depth are inexact.
constexpr double density_tolerance = 0.2;
/// Limits on the fraction of the stress divergence that no density explains.
constexpr double misfit_warning = 0.1;
constexpr double misfit_failure = 0.5;
/// Limit on the value at the first time, relative to the peak.
constexpr double start_failure = 1e-2;

struct Range {
  double low = least_density;
  double high = largest_density;
  bool contains(double value) const { return value >= low && value <= high; }
};

Range densities(const Conventions& conventions) {
  if (!conventions.density)
    return {};
  return {(1.0 - density_tolerance) * *conventions.density, (1.0 + density_tolerance) * *conventions.density};
}

/// Other units under which the density would be one of soil; it goes with stress over velocity and length.
std::string suggestion(double density, const Range& range, const Conventions& c) {
  std::string text;
  const auto offer = [&](std::string_view option, const char* unit, double value) {
    if (range.contains(value))
      text +=
          fmt::format("{} {} {} ({:.4g} kg/m3)", text.empty() ? "; possible:" : " or", option, unit, value);
  };
  for (const auto& [name, size] : stress_units)
    offer("--stress-unit", name, density * size / c.stress_unit);
  for (const auto& [name, size] : velocity_units)
    offer("--velocity-unit", name, density * c.velocity_unit / size);
  for (const auto& [name, size] : length_units)
    offer("--depth-unit", name, density * c.length_unit / size);
  return text;
}

std::string_view words(Direction direction) {
  return direction == Direction::horizontal ? "horizontal" : "vertical";
}

void require_quiet_start(const coupler::ServedSeries& series) {
  const auto first = coupler::peaks(series, 0, 0);
  const auto all = coupler::peaks(series, 0, series.steps() - 1);
  if (all.velocity == 0.0)
    throw std::runtime_error("all velocities are zero");
  if (first.velocity > start_failure * all.velocity)
    throw std::runtime_error(fmt::format(
        "the motion does not start at rest: at the first time, {} s, the velocity is {:.3g} m/s, its peak "
        "{:.3g} m/s",
        series.field.start_time, first.velocity, all.velocity));
  if (first.stress > start_failure * all.stress)
    throw std::runtime_error(fmt::format(
        "the stress at the first time, {} s, is {:.3g} Pa, its peak {:.3g} Pa: only the dynamic part is "
        "wanted; --remove-initial-stress takes the first stress away",
        series.field.start_time, first.stress, all.stress));
}

std::optional<std::string> checked_momentum(const coupler::ServedSeries& series, Direction direction,
                                            const Conventions& conventions) {
  const auto fit = coupler::momentum_fit(series, direction);
  if (!fit)
    return std::nullopt;
  const Range range = densities(conventions);
  const std::string finding = fmt::format("the {} motion obeys rho a = div sigma with rho = {:.5g} kg/m3",
                                          words(direction), fit->density);
  if (fit->misfit > misfit_failure)
    throw std::runtime_error(fmt::format(
        "no density explains the {} motion: rho a = div sigma leaves {:.0f} % of the stress's divergence. "
        "Velocity and "
        "stress do not belong together; relative velocities, another time or depth of one of them do this",
        words(direction), 100.0 * fit->misfit));
  if (range.contains(-fit->density))
    throw std::runtime_error(
        fmt::format("{}: a sign is wrong, --stress-sign, --depth-positive or --vertical-positive", finding));
  if (!range.contains(fit->density))
    throw std::runtime_error(fmt::format("{}, which is outside {:.4g} to {:.4g}: a unit is wrong{}", finding,
                                         range.low, range.high,
                                         suggestion(std::abs(fit->density), range, conventions)));
  return fmt::format("{}{} ({:.1f} % left)", fit->misfit > misfit_warning ? "warning: " : "", finding,
                     100.0 * fit->misfit);
}

} // namespace

std::vector<std::string> check_imported(const coupler::ServedSeries& series, const Conventions& conventions) {
  require_quiet_start(series);
  std::vector<std::string> findings;
  for (const auto direction : {Direction::horizontal, Direction::vertical})
    if (const auto finding = checked_momentum(series, direction, conventions))
      findings.push_back(*finding);
  if (findings.empty())
    findings.emplace_back(
        "warning: units and signs could not be checked, which needs motion at three levels of a "
        "layer");
  return findings;
}

} // namespace tremolo::app
