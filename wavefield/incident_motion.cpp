#include "wavefield/incident_motion.hpp"

#include "base/require.hpp"
#include "base/samples.hpp"
#include "wavefield/layers/recorded_motion.hpp"
#include "wavefield/layers/transfer.hpp"
#include "wavefield/signal/fourier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

/// Below it the outcrop hardly moves in the component that is given.
constexpr double least_outcrop_factor = 1e-3;

/// Length of the first window over the record's.
constexpr std::size_t first_padding = 2;
constexpr std::size_t largest_window = std::size_t{1} << 23;

/// Change by doubling the window, relative to the peak, that ends it.
constexpr double tolerance = 1e-7;

std::string component(WaveType wave) {
  return wave == WaveType::SV ? "horizontal" : "vertical";
}

void require_damped_layers(const LayeredHalfSpace& profile) {
  const bool damped =
      std::ranges::any_of(profile.layers, [](const Layer& layer) { return layer.damping > 0.0; });
  if (!profile.layers.empty() && !damped) {
    throw std::invalid_argument(
        "a within motion under undamped layers has no spectrum where they resonate on a rigid base: give "
        "the layers damping, or use an outcrop or incident motion");
  }
}

/// Division on a periodic window, of which the last half holds the times before the record.
struct Division {
  std::vector<double> incident;
  std::vector<double> amplification; ///< by bin, see IncidentSpectrum
  double step_hz = 0.0;              ///< of the bins
};

Division divided(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                 const RecordedMotion& record, std::size_t window) {
  IncidentSpectrum spectrum = incident_spectrum(profile, wave, angle_rad, record, window);
  RealFourier fourier(window);
  std::ranges::copy(spectrum.bins, fourier.bins().begin());
  fourier.inverse();
  const auto samples = fourier.samples();
  return {.incident = {samples.begin(), samples.end()},
          .amplification = std::move(spectrum.amplification),
          .step_hz = 1.0 / (static_cast<double>(window) * record.dt)};
}

struct Amplification {
  double largest = 0.0;
  double at_hz = 0.0;
};

/// The largest one of any frequency above zero, weighed as the record is.
Amplification largest_amplification(const Division& division, double cutoff) {
  Amplification found;
  for (std::size_t k = 1; k < division.amplification.size(); ++k) {
    const double frequency = static_cast<double>(k) * division.step_hz;
    const double value = band_weight(frequency, cutoff) * division.amplification[k];
    if (value > found.largest)
      found = {value, frequency};
  }
  return found;
}

/// Largest difference of two periodic windows, both halves of the shorter one, over the peak.
double change(std::span<const double> shorter, std::span<const double> longer) {
  const std::size_t half = shorter.size() / 2;
  double difference = 0.0;
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    const std::size_t same_time = i < half ? i : i + longer.size() - shorter.size();
    difference = std::max(difference, std::abs(shorter[i] - longer[same_time]));
  }
  const double largest = peak(longer);
  return largest > 0.0 ? difference / largest : 0.0;
}

/// Puts a periodic window in order of time and leaves out what is negligible, relative to the peak, before
/// and after the record.
Deconvolution in_order(Division division, const RecordedMotion& record, double negligible) {
  const Amplification amplification = largest_amplification(division, record.cutoff);
  std::vector<double>& motion = division.incident;
  std::size_t lead = motion.size() / 2;
  std::rotate(motion.begin(), motion.end() - static_cast<std::ptrdiff_t>(lead), motion.end());
  const double least = negligible * peak(motion);
  const auto matters = [least](double value) { return std::abs(value) > least; };
  const auto first = motion.begin() + static_cast<std::ptrdiff_t>(lead);
  const auto last = first + static_cast<std::ptrdiff_t>(record.samples.size());
  const auto end = std::find_if(motion.rbegin(), std::reverse_iterator(last), matters).base();
  const auto begin = std::find_if(motion.begin(), first, matters);
  return {.incident = {begin, end},
          .lead = static_cast<std::size_t>(first - begin),
          .largest_amplification = amplification.largest,
          .at_hz = amplification.at_hz};
}

/// The incident motion of a record on a window that is doubled until that changes no more.
/// @param allow  throws where a division amplifies more than is allowed
template <class Allow>
Deconvolution deconvolved(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                          const RecordedMotion& record, double negligible, Allow allow) {
  std::size_t window = fast_length(first_padding * record.samples.size());
  Division shorter = divided(profile, wave, angle_rad, record, window);
  allow(shorter);
  for (; 2 * window <= largest_window; window *= 2) {
    Division longer = divided(profile, wave, angle_rad, record, 2 * window);
    allow(longer);
    if (change(shorter.incident, longer.incident) <= tolerance)
      return in_order(std::move(longer), record, negligible);
    shorter = std::move(longer);
  }
  throw std::runtime_error("the incident wave of a recorded motion of " +
                           shortest(static_cast<double>(record.samples.size()) * record.dt) +
                           " s rings on for more than " +
                           shortest(0.5 * static_cast<double>(window) * record.dt) +
                           " s: give the layers more damping, or use an outcrop motion");
}

/// The highest cutoff at which the ground amplifies no frequency more than is allowed.
double highest_cutoff(const Division& division, double allowed) {
  const auto& all = division.amplification;
  const auto first = std::ranges::find_if(all, [allowed](double value) { return value > allowed; });
  return std::floor(static_cast<double>(first - all.begin() - 1) * division.step_hz / band_end * 100.0) /
         100.0;
}

} // namespace

double outcrop_factor(const LayeredHalfSpace& profile, WaveType wave, double angle_rad) {
  validate(profile);
  const Incidence incidence{.wave = wave, .angle_rad = angle_rad};
  validate(incidence);
  if (is_post_critical(profile.half_space, incidence)) {
    throw std::invalid_argument(
        "an outcrop motion at " + shortest(angle_rad * 180.0 / std::numbers::pi) +
        " degrees, beyond the critical angle of " +
        shortest(std::asin(profile.half_space.vs / profile.half_space.vp) * 180.0 / std::numbers::pi) +
        " degrees: its factor to the incident motion is complex there; give the incident motion");
  }
  const Amplitude bare = outcrop(profile.half_space, wave, angle_rad);
  const double factor = wave == WaveType::SV ? bare.ux.real() : bare.uy.real();
  require(std::abs(factor) > least_outcrop_factor, component(wave) + " outcrop motion per incident motion",
          factor, "above 0.001 in magnitude, to be divided by");
  return factor;
}

std::vector<double> incident_from_outcrop(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                          std::span<const double> motion) {
  require_finite_samples("motion", motion);
  const double factor = outcrop_factor(profile, wave, angle_rad);
  std::vector<double> incident(motion.begin(), motion.end());
  for (double& value : incident)
    value /= factor;
  return incident;
}

Deconvolution incident_from_within(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                   std::span<const double> within, double dt, double largest_amplification) {
  validate(profile);
  const RecordedMotion record{.samples = within, .dt = dt, .depth = profile.thickness()};
  validate(record, profile);
  require_positive("largest amplification", largest_amplification, "1");
  require_damped_layers(profile);
  return deconvolved(profile, wave, angle_rad, record, 1e-9, [&](const Division& division) {
    const auto [largest, at_hz] = wavefield::largest_amplification(division, record.cutoff);
    require(largest <= largest_amplification,
            "amplification of the noise of the " + component(wave) + " within motion, at " + shortest(at_hz) +
                " Hz,",
            largest,
            "at most " + shortest(largest_amplification) +
                ": give the layers more damping, or use an outcrop motion");
  });
}

Deconvolution incident_from_record(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                   const RecordedMotion& record) {
  validate(profile);
  validate(record, profile);
  if (record.depth > 0.0)
    require_damped_layers(profile);
  const double factor = std::abs(outcrop_factor(profile, wave, angle_rad));
  return deconvolved(profile, wave, angle_rad, record, 1e-6, [&](const Division& division) {
    const auto [largest, at_hz] = largest_amplification(division, record.cutoff);
    require(factor * largest <= largest_outcrop_over_record,
            "outcrop over recorded motion, by which noise of the record is amplified too, at " +
                shortest(at_hz) + " Hz,",
            factor * largest,
            "at most " + shortest(largest_outcrop_over_record) + ": take a cutoff of " +
                shortest(highest_cutoff(division, largest_outcrop_over_record / factor)) + " Hz or less");
  });
}

} // namespace tremolo::wavefield
