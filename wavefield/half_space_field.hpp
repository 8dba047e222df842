#pragma once

#include "wavefield/half_space.hpp"
#include "wavefield/signal.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::wavefield {

/// Times start + i dt, i = 0 .. count-1, in s.
struct TimeGrid {
  double start = 0.0;
  double dt = 0.0;
  std::size_t count = 0;
};

/// A point of the soil, m: x to the right, y up.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// The field at one point, one value a time of the grid. Stresses are the dynamic part, tension positive.
struct History {
  std::vector<double> ux, uy;                       ///< displacement, m
  std::vector<double> vx, vy;                       ///< particle velocity, m/s
  std::vector<double> sxx, syy, sxy;                ///< stress, Pa
  std::vector<double> vx_rate, vy_rate;             ///< time derivatives of velocity, m/s2
  std::vector<double> sxx_rate, syy_rate, sxy_rate; ///< and of stress, Pa/s
};

enum class Part {
  total,   ///< incident and reflected waves: the free field
  incident ///< the incident upgoing wave alone, as a transmitting base takes it
};

/// Plane P or SV wave in a half-space with a free surface at y = surface_level, at any angle from vertical to
/// grazing, post-critical included.
///
/// Displacement is the time integral of velocity from rest: it vanishes before the wave arrives. Beyond the
/// critical angle, where a plane wave has no first arrival, it vanishes at t -> -infinity; that needs a
/// signal whose own displacement returns to zero, and others are refused.
///
/// Accuracy: 1e-9 of the peak below critical, 1e-6 beyond, for signals within their band limit.
class HalfSpaceField {
public:
  /// @throws std::invalid_argument for values outside their range
  HalfSpaceField(const HalfSpace& half_space, const Incidence& incidence, double surface_level,
                 Signal signal);

  /// Histories at the points, in their order. The spectra of a depth are computed once and shifted along x by
  /// the horizontal slowness. Values at the grid's times are samples of the Fourier synthesis, not
  /// interpolated.
  /// @throws std::invalid_argument for a point above the surface or an empty or ill-formed grid
  std::vector<History> sample(std::span<const Point> points, const TimeGrid& grid,
                              Part part = Part::total) const;

  /// Horizontal slowness, s/m: the field at x is the field at x_0 delayed by slowness_x() (x - x_0).
  double slowness_x() const { return tremolo::wavefield::slowness_x(half_space_, incidence_); }

private:
  HalfSpace half_space_;
  Incidence incidence_;
  double surface_level_;
  Signal signal_;
};

} // namespace tremolo::wavefield
