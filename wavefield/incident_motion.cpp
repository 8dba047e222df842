#include "wavefield/incident_motion.hpp"

#include "wavefield/fourier.hpp"
#include "wavefield/require.hpp"
#include "wavefield/transfer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

/// Below it the outcrop hardly moves in the component that is given.
constexpr double least_outcrop_factor = 1e-3;

/// Window lengths over the record's: what wraps around has four times its length to die away.
constexpr std::size_t deconvolution_padding = 4;

void require_finite(std::span<const double> motion) {
  if (motion.empty()) {
    throw std::invalid_argument("a motion without samples");
  }
  for (const double value : motion) {
    require(std::isfinite(value), "a sample of the motion", value, "finite");
  }
}

std::string component(WaveType wave) {
  return wave == WaveType::SV ? "horizontal" : "vertical";
}

void require_damped_layers(const LayeredHalfSpace& profile) {
  const bool damped =
      std::ranges::any_of(profile.layers, [](const Layer& layer) { return layer.damping > 0.0; });
  if (!profile.layers.empty() && !damped) {
    throw std::invalid_argument(
        "a within motion under undamped layers has no spectrum where they resonate on a rigid base, and "
        "cannot "
        "be divided there: give the layers damping, or use an outcrop or incident motion");
  }
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
  for (double& value : incident) {
    value /= factor;
  }
  return incident;
}

Deconvolution incident_from_within(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                   std::span<const double> within, double dt, double largest_amplification) {
  require_finite(within);
  require_positive("time step of the motion", dt, "s");
  require_positive("largest amplification", largest_amplification, "1");
  validate(profile);
  require_damped_layers(profile);

  RealFourier fourier(fast_length(deconvolution_padding * within.size()));
  const auto samples = fourier.samples();
  std::fill(std::copy(within.begin(), within.end(), samples.begin()), samples.end(), 0.0);
  fourier.forward();
  const auto bins = fourier.bins();
  std::vector<double> frequencies;
  for (std::size_t k = 1; k < bins.size(); ++k) {
    frequencies.push_back(static_cast<double>(k) / (static_cast<double>(samples.size()) * dt));
  }
  const auto transfers = transfer(profile, wave, angle_rad, frequencies, std::array{profile.thickness()});
  const auto of = wave == WaveType::SV ? &Amplitude::ux : &Amplitude::uy;

  Deconvolution result;
  const double length = static_cast<double>(samples.size());
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
  require(result.largest_amplification <= largest_amplification,
          "amplification of the noise of the " + component(wave) + " within motion, at " +
              shortest(result.at_hz) + " Hz,",
          result.largest_amplification,
          "at most " + shortest(largest_amplification) +
              ": give the layers more damping, or use an outcrop motion");
  fourier.inverse();
  result.incident.assign(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(within.size()));
  return result;
}

} // namespace tremolo::wavefield
