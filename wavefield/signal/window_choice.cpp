#include "wavefield/signal/window_choice.hpp"

#include "base/require.hpp"
#include "wavefield/signal/synthesis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::wavefield {
namespace {

constexpr double first_padding = 1.25;
constexpr double first_padding_with_tails = 2.0;
constexpr std::size_t largest_chosen_window = std::size_t{1} << 23;

/// Vertical slowness of a wave that propagates, s/m; 0 of one that is evanescent.
double vertical_slowness(double speed, double p) {
  return std::sqrt(std::max(0.0, (1.0 / speed - p) * (1.0 / speed + p)));
}

/// Fields whose spectra have a branch point at zero frequency: the error falls with a low power of the
/// window.
bool has_branch_point(const FieldSetup& setup) {
  return setup.profile.damping.model == DampingModel::kjartansson && is_damped(setup.profile);
}

/// Only delayed copies of the signal: any window that holds them is exact.
bool is_sum_of_pulses(const FieldSetup& setup) {
  return !has_tails(setup) && !is_damped(setup.profile) &&
         (setup.profile.layers.empty() || setup.part == Part::incident);
}

/// Change of the surface velocity by doubling, relative to its peak, that ends it.
double tolerance_of(const FieldSetup& setup, const SynthesisOptions& options) {
  if (options.exponential_window)
    return 1e-8;
  if (has_branch_point(setup))
    return 1e-7;
  return setup.has_kink() ? 1e-9 : 1e-10;
}

Window window_with(const FieldSetup& setup, const TimeGrid& grid, const Interval& interval, double padding,
                   bool exponential) {
  const double highest = setup.signal.highest_frequency;
  return exponential ? make_exponential_window(grid, interval, padding, highest)
                     : make_window(grid, interval, padding, highest);
}

} // namespace

bool has_tails(const FieldSetup& setup) {
  return setup.has_kink() || has_branch_point(setup);
}

Interval interval_of(const FieldSetup& setup, std::span<const Point> points, const TimeGrid& grid) {
  const HalfSpace& deep = setup.profile.half_space;
  const double p = slowness_x(deep, setup.incidence);
  const double q_incident = vertical_slowness(setup.incidence.wave == WaveType::SV ? deep.vs : deep.vp, p);
  const double top_of_half_space = setup.top_of(setup.profile.layers.size());
  double through_layers = 0.0;
  for (const Layer& layer : setup.profile.layers)
    through_layers += 2.0 * layer.thickness * vertical_slowness(layer.vs, p);
  double earliest = 0.0; // the signal itself, undelayed, is sampled in the same window
  double latest = 0.0;
  for (const Point& point : points) {
    const double along = p * (point.x - setup.incidence.x_reference);
    const double depth_below_top = std::max(0.0, top_of_half_space - point.y);
    const double first =
        along + q_incident * (top_of_half_space - depth_below_top - setup.incidence.y_reference);
    const double last = along + q_incident * (top_of_half_space - setup.incidence.y_reference) +
                        through_layers + vertical_slowness(deep.vs, p) * depth_below_top;
    earliest = std::min(earliest, first);
    latest = std::max(latest, last);
  }
  return {std::min(grid.start, setup.signal.begin + earliest),
          std::max(grid.start + static_cast<double>(grid.count) * grid.dt, setup.signal.end + latest)};
}

double relative_change(const std::vector<History>& a, const std::vector<History>& b,
                       std::span<std::vector<double> History::*const> kind, double least) {
  double difference = 0.0;
  double peak = least;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const auto series : kind) {
      for (std::size_t t = 0; t < (a[i].*series).size(); ++t) {
        difference = std::max(difference, std::abs((a[i].*series)[t] - (b[i].*series)[t]));
        peak = std::max(peak, std::abs((b[i].*series)[t]));
      }
    }
  }
  return peak > 0.0 ? difference / peak : 0.0;
}

Window choose_window(const FieldSetup& setup, std::span<const Point> points, const TimeGrid& grid,
                     const SynthesisOptions& options) {
  const Interval interval = interval_of(setup, points, grid);
  const auto window = [&](double padding) {
    return window_with(setup, grid, interval, padding, options.exponential_window);
  };
  if (options.padding)
    return window(*options.padding);
  if (is_sum_of_pulses(setup))
    return window(first_padding);
  const auto [first, last] = std::ranges::minmax(points, {}, &Point::x);
  const double level =
      setup.part == Part::total ? setup.surface_level : std::ranges::max(points, {}, &Point::y).y;
  const std::array<Point, 2> ends{{{first.x, level}, {last.x, level}}};
  const Quantities velocity{.displacement = false, .stress = false, .strain = false, .rates = false};
  const auto motion = [&](const Window& on) {
    return Synthesis(setup, on).sample(ends, grid.count, velocity);
  };

  const bool tails = has_tails(setup);
  const double tolerance = tolerance_of(setup, options);
  const double scale = options.velocity_scale ? *options.velocity_scale : peak_velocity(setup.signal);
  Window chosen = window(tails ? first_padding_with_tails : first_padding);
  std::vector<History> with_chosen = motion(chosen);
  for (double padding = tails ? first_padding_with_tails : first_padding;;) {
    padding *= 2.0;
    const Window doubled = window(padding);
    std::vector<History> with_doubled = motion(doubled);
    const double still =
        relative_change(with_chosen, with_doubled, std::array{&History::vx, &History::vy}, scale);
    if (still <= tolerance)
      return chosen;
    if (doubled.length > largest_chosen_window) {
      throw std::runtime_error("the field does not fit into a window of " + shortest(doubled.duration()) +
                               " s: its surface velocity changes by " + shortest(still) +
                               " of the peak when that is reached by doubling. The soil rings too long: damp "
                               "it, use an exponential "
                               "window where that is valid, or choose the padding yourself");
    }
    chosen = doubled;
    with_chosen = std::move(with_doubled);
  }
}

std::string why_no_exponential_window(const FieldSetup& setup) {
  const LayeredHalfSpace& profile = setup.profile;
  const double p = slowness_x(profile.half_space, setup.incidence);
  if (is_damped(profile)) {
    if (jumps_at_zero_frequency(profile.damping.model)) {
      return "damping that is the same at all frequencies (" + std::string(name(profile.damping.model)) +
             ") is not causal: its moduli jump at zero frequency";
    }
    return p == 0.0 ? ""
                    : "with damping (" + std::string(name(profile.damping.model)) +
                          ") and oblique incidence the horizontal slowness " + shortest(p) +
                          " s/m exceeds the soil's own at some frequency, where waves become evanescent";
  }
  for (std::size_t j = 0; j <= profile.layers.size(); ++j) {
    const double vp = j < profile.layers.size() ? profile.layers[j].vp : profile.half_space.vp;
    if (p * vp >= 1.0) {
      const std::string where =
          j < profile.layers.size() ? "layer " + std::to_string(j + 1) + " from the top" : "the half-space";
      return "P waves in " + where + " (vp = " + shortest(vp) +
             " m/s) are evanescent: the horizontal slowness is " + shortest(p) +
             " s/m, must be below 1/vp = " + shortest(1.0 / vp) + " s/m";
    }
  }
  return "";
}

} // namespace tremolo::wavefield
