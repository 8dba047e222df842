#include "wavefield/incident_motion.hpp"

#include "base/require.hpp"
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

/// What is left out at both ends of an incident motion, relative to its peak.
constexpr double negligible = 1e-9;

void require_finite(std::span<const double> motion) {
  if (motion.empty())
    throw std::invalid_argument("a motion without samples");
  for (const double value : motion)
    require(std::isfinite(value), "a sample of the motion", value, "finite");
}

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
  double largest_amplification = 0.0;
  double at_hz = 0.0;
};

Division divided(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                 std::span<const double> within, double dt, std::size_t window) {
  RealFourier fourier(window);
  const auto samples = fourier.samples();
  std::fill(std::copy(within.begin(), within.end(), samples.begin()), samples.end(), 0.0);
  fourier.forward();
  const auto bins = fourier.bins();
  const double length = static_cast<double>(window);
  std::vector<double> frequencies;
  for (std::size_t k = 1; k < bins.size(); ++k)
    frequencies.push_back(static_cast<double>(k) / (length * dt));
  const auto transfers = transfer(profile, wave, angle_rad, frequencies, std::array{profile.thickness()});
  const auto of = wave == WaveType::SV ? &Amplitude::ux : &Amplitude::uy;

  Division result;
  // At zero frequency the layers ride on the half-space: the lowest frequency tells its factor.
  bins[0] /= length * (transfers.front().front().*of).real();
  for (std::size_t k = 1; k < bins.size(); ++k) {
    const Complex per_incident = transfers[k - 1].front().*of;
    const double amplification = 1.0 / std::abs(per_incident);
    if (!(amplification <= result.largest_amplification)) {
      result.largest_amplification = amplification;
      result.at_hz = frequencies[k - 1];
    }
    bins[k] /= length * per_incident;
  }
  fourier.inverse();
  result.incident.assign(samples.begin(), samples.end());
  return result;
}

double peak(std::span<const double> motion) {
  return std::abs(*std::ranges::max_element(motion, {}, [](double value) { return std::abs(value); }));
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

/// Puts a periodic window in order of time and leaves out what is negligible before and after the record.
Deconvolution in_order(Division division, std::size_t record) {
  std::vector<double>& motion = division.incident;
  std::size_t lead = motion.size() / 2;
  std::rotate(motion.begin(), motion.end() - static_cast<std::ptrdiff_t>(lead), motion.end());
  const double least = negligible * peak(motion);
  const auto matters = [least](double value) { return std::abs(value) > least; };
  const auto first = motion.begin() + static_cast<std::ptrdiff_t>(lead);
  const auto end = std::find_if(motion.rbegin(),
                                std::reverse_iterator(first + static_cast<std::ptrdiff_t>(record)), matters)
                       .base();
  const auto begin = std::find_if(motion.begin(), first, matters);
  return {.incident = {begin, end},
          .lead = static_cast<std::size_t>(first - begin),
          .largest_amplification = division.largest_amplification,
          .at_hz = division.at_hz};
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
  require_finite(motion);
  const double factor = outcrop_factor(profile, wave, angle_rad);
  std::vector<double> incident(motion.begin(), motion.end());
  for (double& value : incident)
    value /= factor;
  return incident;
}

Deconvolution incident_from_within(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                   std::span<const double> within, double dt, double largest_amplification) {
  require_finite(within);
  require_positive("time step of the motion", dt, "s");
  require_positive("largest amplification", largest_amplification, "1");
  validate(profile);
  require_damped_layers(profile);

  const auto divided_on = [&](std::size_t window) {
    Division division = divided(profile, wave, angle_rad, within, dt, window);
    require(division.largest_amplification <= largest_amplification,
            "amplification of the noise of the " + component(wave) + " within motion, at " +
                shortest(division.at_hz) + " Hz,",
            division.largest_amplification,
            "at most " + shortest(largest_amplification) +
                ": give the layers more damping, or use an outcrop motion");
    return division;
  };
  std::size_t window = fast_length(first_padding * within.size());
  for (Division shorter = divided_on(window); 2 * window <= largest_window; window *= 2) {
    Division longer = divided_on(2 * window);
    if (change(shorter.incident, longer.incident) <= tolerance)
      return in_order(std::move(longer), within.size());
    shorter = std::move(longer);
  }
  throw std::runtime_error("the incident wave of a within motion of " +
                           shortest(static_cast<double>(within.size()) * dt) + " s rings on for more than " +
                           shortest(0.5 * static_cast<double>(window) * dt) +
                           " s: give the layers more damping, or use an outcrop motion");
}

} // namespace tremolo::wavefield
