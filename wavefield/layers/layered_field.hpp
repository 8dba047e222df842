#pragma once

#include "wavefield/layers/layered_half_space.hpp"
#include "wavefield/signal/history.hpp"
#include "wavefield/signal/signal.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::wavefield {

struct FieldSetup;

/// Choice of the periodic window of the Fourier synthesis.
struct SynthesisOptions {
  /// Length of the window over that of signal and requested times together, at least 1. Without it the window
  /// is doubled until the surface motion no longer changes.
  std::optional<double> padding;
  /// Synthesis at complex frequencies s = i omega + epsilon: what wraps around is damped by exp(-epsilon T).
  /// Valid for causal fields only, and refused elsewhere.
  bool exponential_window = false;
  /// Velocity that the window's error is relative to, m/s, where the surface moves less: that of a motion of
  /// which this one is a part. Without it, the largest velocity of the incident motion.
  std::optional<double> velocity_scale;
};

/// Largest change of each kind of quantity when the window is doubled, relative to its peak.
struct WrapAroundError {
  double window = 0.0; ///< s; the one that was doubled
  double displacement = 0.0;
  double velocity = 0.0;
  double stress = 0.0;
};

/// Plane P or SV wave that comes up through a half-space under layers, at any angle from vertical to grazing,
/// post-critical included. The free surface is at y = surface_level; the half-space begins at surface_level
/// minus the thickness of the layers.
///
/// Displacement is the time integral of velocity from rest: it vanishes before the wave arrives. Where a
/// plane wave has no first arrival (beyond the critical angle; oblique in a half-space of constant damping)
/// it vanishes at t -> -infinity; that needs a signal whose own displacement returns to zero, and others are
/// refused if displacement is asked for.
///
/// Accuracy: 1e-9 of the peak below critical and without constant damping, else 1e-6, for signals within
/// their band limit; of the incident motion's peak where the surface moves less in the times asked for.
class LayeredField {
public:
  /// @throws std::invalid_argument for values outside their range, and for an exponential window where the
  ///         field is not causal
  LayeredField(LayeredHalfSpace profile, const Incidence& incidence, double surface_level, Signal signal,
               const SynthesisOptions& options = {});

  /// Histories at the points, in their order. The spectra of a depth are computed once and shifted along x by
  /// the horizontal slowness. Values at the grid's times are samples of the Fourier synthesis, not
  /// interpolated.
  /// @throws std::invalid_argument for a point above the surface, an incident wave above the half-space, or
  /// an
  ///         empty or ill-formed grid
  /// @throws std::runtime_error if the profile rings longer than the largest window
  std::vector<History> sample(std::span<const Point> points, const TimeGrid& grid, Part part = Part::total,
                              const Quantities& quantities = {}) const;

  /// Change at the points when the window chosen by sample() is doubled.
  WrapAroundError wrap_around_error(std::span<const Point> points, const TimeGrid& grid) const;

  /// Horizontal slowness, s/m: the field at x is the field at x_0 delayed by slowness_x() (x - x_0).
  double slowness_x() const { return tremolo::wavefield::slowness_x(profile_.half_space, incidence_); }

  /// The field that a part of the incident motion alone makes.
  /// @param velocity_scale  of the whole motion, m/s (SynthesisOptions)
  LayeredField with_signal(Signal signal, double velocity_scale) const;
  const Signal& signal() const { return signal_; }

  /// Whether the field has algebraic tails: beyond the critical angle, with constant and with Kjartansson
  /// damping.
  bool has_tails(Part part) const;

  double top_of_half_space() const { return surface_level_ - profile_.thickness(); } ///< m
  const LayeredHalfSpace& profile() const { return profile_; }

private:
  FieldSetup setup(Part part) const;

  LayeredHalfSpace profile_;
  Incidence incidence_;
  double surface_level_;
  Signal signal_;
  SynthesisOptions options_;
};

} // namespace tremolo::wavefield
