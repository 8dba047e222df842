// The field is g(t) = integral over all w of G(w) exp(i w t), G = coefficient x signal spectrum x phase,
// conjugate for w < 0. On a window of length T the integral becomes the trapezoidal sum over w_k = 2 pi k /
// T.
//
// Below the critical angle G is analytic on the whole axis, the sum is that of the periodic continuation, and
// it is exact as soon as the window holds signal and grid. Beyond it G has a kink at w = 0 (the coefficients
// jump to their conjugates), which is the frequency side of tails like t^-3 that never end. The sum over w >=
// 0 is then a quadrature of a smooth function on a half line, and Gregory's end correction (Hildebrand 1987,
// Introduction to Numerical Analysis, sec. 5.9)
//
//   integral / dw = G_0/2 + G_1 + G_2 + ... + 1/12 D G_0 - 1/24 D^2 G_0 + 19/720 D^3 G_0 - 3/160 D^4 G_0
//                   + 863/60480 D^5 G_0,      D G_k = G_{k+1} - G_k,
//
// raises its order in 1/T from 2 to 7: it changes the weights of six bins.
//
// Displacement has the spectrum F / (i w) and at w = 0 its limit, minus the first moment of the signal.

#include "wavefield/synthesis.hpp"

#include "wavefield/require.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;
constexpr std::size_t largest_window = std::size_t{1} << 27;

/// The weights that Gregory's corrections give to the first bins, the sum above collected by G_k.
std::array<double, 6> gregory_weights() {
  constexpr std::array<double, 5> correction = {1.0 / 12.0, -1.0 / 24.0, 19.0 / 720.0, -3.0 / 160.0,
                                                863.0 / 60480.0};
  std::array<double, 6> weights = {0.5, 1.0, 1.0, 1.0, 1.0, 1.0};
  for (std::size_t order = 1; order <= correction.size(); ++order) {
    double binomial = order % 2 == 0 ? 1.0 : -1.0; // (-1)^(order-k) binomial(order, k), from k = 0
    for (std::size_t k = 0; k <= order; ++k) {
      weights[k] += correction[order - 1] * binomial;
      binomial *= -static_cast<double>(order - k) / static_cast<double>(k + 1);
    }
  }
  return weights;
}

} // namespace

Window make_window(const TimeGrid& grid, double begin, double end, double padding, double highest_frequency) {
  // Four samples a period of the highest frequency: Nyquist's limit twice over.
  const double stride = std::max(1.0, std::ceil(grid.dt * 4.0 * highest_frequency));
  Window window;
  window.dt = grid.dt / stride;
  const double length = std::ceil(padding * (end - begin) / window.dt);
  require(stride < 1e6 && length < static_cast<double>(largest_window),
          "number of samples of the Fourier window", length,
          "below 2^27: shorten the record, or lower the highest frequency of the signal");
  window.stride = static_cast<std::size_t>(stride);
  window.length = fast_length(static_cast<std::size_t>(length) + 2);
  const double before = 0.5 * (padding - 1.0) * (end - begin) + (grid.start - begin);
  window.offset = static_cast<std::size_t>(std::ceil(before / window.dt));
  window.start = grid.start - static_cast<double>(window.offset) * window.dt;
  return window;
}

Synthesis::Synthesis(const Signal& signal, const Window& window, std::vector<PlaneWave> waves, bool one_sided)
    : window_(window), waves_(std::move(waves)), one_sided_(one_sided), fourier_(window.length) {
  const auto samples = fourier_.samples();
  double sum = 0.0;
  double absolute_sum = 0.0;
  double first_moment = 0.0;
  for (std::size_t j = 0; j < window.length; ++j) {
    const double t = static_cast<double>(j) * window.dt;
    const double time = window.start + t;
    const bool active = time >= signal.begin && time <= signal.end;
    samples[j] = active ? signal.velocity(time) : 0.0;
    require(std::isfinite(samples[j]), "velocity of the signal at t = " + shortest(time) + " s", samples[j],
            "finite");
    sum += samples[j];
    absolute_sum += std::abs(samples[j]);
    first_moment += t * samples[j];
  }
  if (one_sided && std::abs(sum) > 1e-6 * absolute_sum) {
    throw std::invalid_argument(
        "the signal leaves a displacement of " + shortest(sum * window.dt) +
        " m, must be 0 beyond the critical angle, where it would grow without end: remove "
        "the offset of the motion");
  }

  fourier_.forward();
  const auto bins = fourier_.bins();
  double largest = 0.0;
  for (const Complex& bin : bins) {
    largest = std::max(largest, std::abs(bin));
  }
  // Bins below rounding are not worth a phase at every depth.
  std::size_t band = bins.size();
  while (band > 1 && std::abs(bins[band - 1]) <= 1e-15 * largest) {
    --band;
  }
  const double scale = 1.0 / static_cast<double>(window.length);
  velocity_.resize(band);
  displacement_.resize(band);
  for (std::size_t k = 0; k < band; ++k) {
    velocity_[k] = bins[k] * scale;
    displacement_[k] = k == 0 ? Complex(-first_moment * scale) : velocity_[k] / Complex(0.0, omega(k));
  }
}

double Synthesis::omega(std::size_t bin) const {
  return 2.0 * std::numbers::pi * static_cast<double>(bin) /
         (static_cast<double>(window_.length) * window_.dt);
}

Synthesis::DepthSpectra Synthesis::at_depth(double y, double advance) const {
  const Spectrum zero(velocity_.size());
  DepthSpectra at = {zero, zero, zero, zero, zero, zero, zero};
  for (const PlaneWave& wave : waves_) {
    const Complex exponent = Complex(0.0, 1.0) * (advance - wave.q * y);
    for (std::size_t k = 0; k < velocity_.size(); ++k) {
      const Complex phase = std::exp(exponent * omega(k));
      const Complex velocity = phase * velocity_[k];
      const Complex displacement = phase * displacement_[k];
      at.ux[k] += wave.vx * displacement;
      at.uy[k] += wave.vy * displacement;
      at.vx[k] += wave.vx * velocity;
      at.vy[k] += wave.vy * velocity;
      at.sxx[k] += wave.sxx * velocity;
      at.syy[k] += wave.syy * velocity;
      at.sxy[k] += wave.sxy * velocity;
    }
  }
  return at;
}

void Synthesis::to_time(const Spectrum& spectrum, const Spectrum& factors) {
  const auto bins = fourier_.bins();
  std::fill(bins.begin(), bins.end(), Complex());
  for (std::size_t k = 0; k < spectrum.size(); ++k) {
    bins[k] = factors[k] * spectrum[k];
  }
  if (one_sided_) {
    const auto weights = gregory_weights();
    bins[0] *= 2.0 * weights[0]; // the inverse transform counts bin 0 once, all others with their conjugates
    for (std::size_t k = 1; k < std::min(weights.size(), bins.size()); ++k) {
      bins[k] *= weights[k];
    }
  }
  fourier_.inverse();
}

std::vector<double> Synthesis::on_grid(std::size_t count) {
  const auto samples = fourier_.samples();
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = samples[window_.offset + i * window_.stride];
  }
  return values;
}

std::vector<double> Synthesis::displacement(const Spectrum& spectrum, const Spectrum& shift,
                                            double mean_velocity, std::size_t count) {
  to_time(spectrum, shift);
  std::vector<double> values = on_grid(count);
  if (one_sided_) {
    return values;
  }
  // At the window's start nothing has arrived yet, so displacement is zero there; the window's mean velocity,
  // which a periodic function cannot integrate, is a ramp from there.
  const double at_start = fourier_.samples()[0];
  for (std::size_t i = 0; i < count; ++i) {
    const double since_start = static_cast<double>(window_.offset + i * window_.stride) * window_.dt;
    values[i] += mean_velocity * since_start - at_start;
  }
  return values;
}

History Synthesis::history(const DepthSpectra& spectra, double delay, std::size_t count) {
  Spectrum shift(velocity_.size());
  Spectrum shifted_rate(velocity_.size());
  for (std::size_t k = 0; k < shift.size(); ++k) {
    shift[k] = std::polar(1.0, -omega(k) * delay);
    shifted_rate[k] = Complex(0.0, omega(k)) * shift[k];
  }
  const auto series = [&](const Spectrum& spectrum, const Spectrum& factors) {
    to_time(spectrum, factors);
    return on_grid(count);
  };
  History history;
  history.ux = displacement(spectra.ux, shift, spectra.vx[0].real(), count);
  history.uy = displacement(spectra.uy, shift, spectra.vy[0].real(), count);
  history.vx = series(spectra.vx, shift);
  history.vy = series(spectra.vy, shift);
  history.sxx = series(spectra.sxx, shift);
  history.syy = series(spectra.syy, shift);
  history.sxy = series(spectra.sxy, shift);
  history.vx_rate = series(spectra.vx, shifted_rate);
  history.vy_rate = series(spectra.vy, shifted_rate);
  history.sxx_rate = series(spectra.sxx, shifted_rate);
  history.syy_rate = series(spectra.syy, shifted_rate);
  history.sxy_rate = series(spectra.sxy, shifted_rate);
  return history;
}

} // namespace tremolo::wavefield
