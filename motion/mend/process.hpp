#pragma once

// Processing of samples at equal steps. Every function returns the samples anew; quantities and units are the
// caller's, except for the baseline, which is that of accelerations.

#include <span>
#include <utility>
#include <vector>

namespace tremolo::motion {

/// Half a cosine from 0 to 1 over the first `begin` s and from 1 to 0 over the last `end` s.
/// @throws std::invalid_argument where the two overlap or one is negative
std::vector<double> tapered(std::vector<double> samples, double dt, double begin, double end);

/// Scaled to the largest absolute value `peak` (> 0).
std::vector<double> scaled_to_peak(std::vector<double> samples, double peak);

/// Later by `delay` s (earlier where negative): zeros enter at the start, or samples leave there. A part of a
/// step is shifted by the interpolation of resampled().
std::vector<double> shifted(std::span<const double> samples, double dt, double delay);

/// Two perpendicular components (1, 2) seen along axes turned by `degrees` from 1 towards 2:
/// (a cos + b sin, -a sin + b cos). @throws std::invalid_argument for components of different lengths
std::pair<std::vector<double>, std::vector<double>> rotated(std::span<const double> first,
                                                            std::span<const double> second, double degrees);

/// Band-limited interpolation to another step by a windowed sinc. Below 0.85 of the lower of the two Nyquist
/// frequencies an infinite signal keeps its values to 1e-6 of its amplitude; to a coarser step, what lies
/// above the new Nyquist frequency falls to 1e-6. Beyond its ends the record is continued by point
/// reflection, so that an offset makes no step to ring from.
std::vector<double> resampled(std::span<const double> samples, double dt, double new_dt);

/// Corner frequencies in Hz; zero leaves that side open.
struct Band {
  double low = 0.0;
  double high = 0.0;
  int order = 4; ///< of each of the two filters, 1 to 10
};

/// Butterworth high-pass at `low` and low-pass at `high` by the bilinear transform with prewarped corners,
/// run forward and backward: zero phase, and the gain
///     1/((1 + (W_l/W)^2n) (1 + (W/W_h)^2n)),   W = tan(pi f dt),
/// which is 1/2 at a corner. The record is continued by zeros long enough for the filter to die out.
/// @throws std::invalid_argument unless 0 <= low < high < 1/(2 dt), at least one > 0, and the order is
/// allowed
std::vector<double> band_passed(std::span<const double> samples, double dt, const Band& band);

/// The series that the baseline's polynomial is fitted to.
enum class BaselineFit { velocity, displacement };

/// Subtracts from the acceleration a polynomial whose integral (of `degree`, at least 1) fits the velocity,
/// or whose double integral (of `degree`, at least 2) fits the displacement, by least squares under the
/// constraint that the velocity ends at zero.
/// @throws std::invalid_argument for a degree out of range (at most 10) or fewer samples than coefficients
std::vector<double> baseline_corrected(std::span<const double> acceleration, double dt, BaselineFit fit,
                                       int degree);

} // namespace tremolo::motion
