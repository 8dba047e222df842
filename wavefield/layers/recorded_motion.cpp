// With T(f) the motion at the recorder's depth per unit incident motion (transfer.hpp), the incident motion
// is
//
//     I(f) = W(f) R(f) / T(f),     W(f) = 1/2 erfc((f/f_c - 1.125) 32).
//
// At the surface T has no zeros, but its inverse grows with the damping of the layers like exp(w xi H / c_s)
// and would make noise the largest part of the answer: hence the cutoff f_c. W leaves 1 to 8e-9 below f_c,
// and its answer to an impulse, a Gaussian over a sine, has died out to 1e-8 after 43 / f_c.

#include "wavefield/layers/recorded_motion.hpp"

#include "base/require.hpp"
#include "base/samples.hpp"
#include "wavefield/layers/transfer.hpp"
#include "wavefield/signal/fourier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tremolo::wavefield {
namespace {

/// The forward transform of the record on a window, zeros behind it.
void transform(RealFourier& fourier, std::span<const double> record) {
  const auto samples = fourier.samples();
  std::fill(std::copy(record.begin(), record.end(), samples.begin()), samples.end(), 0.0);
  fourier.forward();
}

/// Frequencies of the bins above zero at which the record has something.
std::vector<double> frequencies(const RecordedMotion& record, std::size_t window) {
  std::vector<double> result;
  for (std::size_t k = 1; k <= window / 2; ++k) {
    const double frequency = static_cast<double>(k) / (static_cast<double>(window) * record.dt);
    if (frequency >= band_end * record.cutoff)
      break;
    result.push_back(frequency);
  }
  if (result.empty())
    throw std::invalid_argument("a cutoff of " + shortest(record.cutoff) +
                                " Hz leaves no frequency of a record of " +
                                shortest(static_cast<double>(record.samples.size()) * record.dt) + " s");
  return result;
}

} // namespace

void validate(const RecordedMotion& record, const LayeredHalfSpace& profile) {
  require_finite_samples("motion", record.samples);
  require_positive("time step of the motion", record.dt, "s");
  const double rounding = 1e-9 * profile.thickness();
  require(record.depth >= 0.0 && record.depth <= profile.thickness() + rounding, "depth of the record",
          record.depth, "from 0 to " + shortest(profile.thickness()) + " m, the thickness of the layers");
  require(record.cutoff > 0.0, "cutoff", record.cutoff, "above 0 Hz");
}

double band_weight(double frequency, double cutoff) {
  constexpr double middle = 1.125;
  constexpr double steepness = 32.0;
  if (!(frequency > cutoff))
    return 1.0;
  return frequency < band_end * cutoff ? 0.5 * std::erfc((frequency / cutoff - middle) * steepness) : 0.0;
}

std::vector<double> band_limited(const RecordedMotion& record) {
  const std::size_t window = fast_length(2 * record.samples.size());
  RealFourier fourier(window);
  transform(fourier, record.samples);
  const auto bins = fourier.bins();
  const double length = static_cast<double>(window);
  for (std::size_t k = 0; k < bins.size(); ++k)
    bins[k] *= band_weight(static_cast<double>(k) / (length * record.dt), record.cutoff) / length;
  fourier.inverse();
  const auto samples = fourier.samples().first(record.samples.size());
  return {samples.begin(), samples.end()};
}

IncidentSpectrum incident_spectrum(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                   const RecordedMotion& record, std::size_t window) {
  RealFourier fourier(window);
  transform(fourier, record.samples);
  const auto recorded = fourier.bins();
  const double length = static_cast<double>(window);
  const auto band = frequencies(record, window);
  const auto transfers =
      transfer(profile, wave, angle_rad, band, std::array{std::min(record.depth, profile.thickness())});
  const auto component = wave == WaveType::SV ? &Amplitude::ux : &Amplitude::uy;

  IncidentSpectrum spectrum{.bins = std::vector<std::complex<double>>(recorded.size()), .amplification = {}};
  // At zero frequency the layers move with the half-space: the lowest frequency gives the factor.
  const double riding = (transfers.front().front().*component).real();
  spectrum.bins[0] = recorded[0] / (length * riding);
  spectrum.amplification.push_back(1.0 / std::abs(riding));
  for (std::size_t k = 1; k <= band.size(); ++k) {
    const std::complex<double> per_incident = transfers[k - 1].front().*component;
    const double amplification = 1.0 / std::abs(per_incident);
    require(std::isfinite(amplification), "incident over recorded motion at " + shortest(band[k - 1]) + " Hz",
            amplification, "finite");
    spectrum.amplification.push_back(amplification);
    spectrum.bins[k] = recorded[k] * band_weight(band[k - 1], record.cutoff) / (length * per_incident);
  }
  return spectrum;
}

} // namespace tremolo::wavefield
