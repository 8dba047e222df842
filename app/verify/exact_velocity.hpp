#pragma once

#include "wavefield/superposition.hpp"

#include <span>
#include <vector>

namespace tremolo::app {

/// Samples per period of the highest frequency of the signal, between which velocities are interpolated.
inline constexpr double samples_per_period = 32.0;

/// The exact particle velocity at any point of a box and any time of a run, cheaply.
///
/// At each of the given levels the history v(t) at x_min is computed once; elsewhere on the level it is
/// v(t - p (x - x_min)), p the horizontal slowness of each plane wave, and between its samples the cubic
/// Hermite interpolant of values and rates, which errs by (omega dt)^4 / 384: with 32 samples per period of
/// the highest frequency, 5e-8 at a third of it, where motions end in practice.
class ExactVelocity {
public:
  struct Value {
    double vx = 0.0, vy = 0.0; ///< m/s
    double ax = 0.0, ay = 0.0; ///< time derivatives, m/s2
  };

  /// The range of positions and times at which values will be requested; m and s.
  struct Range {
    double x_min, x_max;
    double t_min, t_max;
  };

  /// @param highest_frequency  of the signal, Hz
  /// @throws std::invalid_argument for a level above the surface
  ExactVelocity(const wavefield::Superposition& field, std::span<const double> levels, const Range& range,
                double highest_frequency);

  /// The value at y = levels[level]. Times outside the range are clamped to it.
  Value at(std::size_t level, double x, double t) const;

private:
  struct Sample {
    double vx, vy, ax, ay;
  };
  /// A plane wave on the line x_min.
  struct Wave {
    double slowness = 0.0; ///< s/m
    wavefield::TimeGrid grid;
    std::vector<Sample> samples; ///< [level * grid.count + step]

    Wave(const wavefield::LayeredField& field, std::span<const double> levels, const Range& range,
         double highest_frequency);
    Value at(std::size_t level, double distance, double t) const;
  };

  double x_min_ = 0.0;
  std::vector<Wave> waves_;
};

} // namespace tremolo::app
