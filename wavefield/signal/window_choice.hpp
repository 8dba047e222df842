#pragma once

#include "wavefield/layers/field_spectra.hpp"
#include "wavefield/layers/layered_field.hpp"
#include "wavefield/signal/window.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::wavefield {

/// Whether the field has algebraic tails, for ever: those of a kink and of a branch point of its spectra at
/// zero frequency.
bool has_tails(const FieldSetup& setup);

/// The interval that holds the requested times, the signal, and at every point its passing once up and down
/// through the layers; reverberation comes on top.
Interval interval_of(const FieldSetup& setup, std::span<const Point> points, const TimeGrid& grid);

/// Largest difference over largest value of b, of some of the series of all points; over `least` where b is
/// smaller.
double relative_change(const std::vector<History>& a, const std::vector<History>& b,
                       std::span<std::vector<double> History::*const> kind, double least = 0.0);

/// The window that the options ask for. Without a padding it is doubled until the velocities of the surface,
/// at both ends along x, change by less than 1e-10 of their peak, or of the velocity scale where that is
/// larger; where the field has algebraic tails 1e-9, and 1e-7 if they are those of Kjartansson damping; with
/// an exponential window 1e-8.
/// @throws std::runtime_error if the largest window does not hold the reverberation
Window choose_window(const FieldSetup& setup, std::span<const Point> points, const TimeGrid& grid,
                     const SynthesisOptions& options);

/// Why the field is not the analytic continuation of its spectra to s = i omega + epsilon, which an
/// exponential window needs; empty where it is.
std::string why_no_exponential_window(const FieldSetup& setup);

} // namespace tremolo::wavefield
