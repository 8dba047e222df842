// The field is g(t) = integral over all w of G(w) exp(i w t), conjugate for w < 0. On a window of length T
// the integral becomes the trapezoidal sum over w_k = 2 pi k / T.
//
// Where G is analytic around zero frequency, the sum is that of the periodic continuation, and it is exact as
// soon as the window holds signal, grid and reverberation. Beyond the critical angle and with constant
// damping G has a kink at w = 0 (it jumps to its conjugate), which is the frequency side of tails like t^-3
// that never end. The sum over w >= 0 is then a quadrature of a smooth function on a half line, and Gregory's
// end correction (Hildebrand 1987, Introduction to Numerical Analysis, sec. 5.9)
//
//   integral / dw = G_0/2 + G_1 + G_2 + ... + 1/12 D G_0 - 1/24 D^2 G_0 + 19/720 D^3 G_0 - 3/160 D^4 G_0
//                   + 863/60480 D^5 G_0,      D G_k = G_{k+1} - G_k,
//
// raises its order in 1/T from 2 to 7: it changes the weights of six bins.
//
// Displacement has the spectrum V / (i w). The pole at w = 0, of a signal that leaves an offset, belongs to
// the displacement c U_inc that the static response c makes of the incident one, which is integrated from the
// window's start; what is left, (V - c V_inc) / (i w), has no pole. Its value at w = 0 is extrapolated from
// six bins where there is a kink; else it is 0 without an offset, and with one such that the window starts at
// rest.
//
// With an exponential window (Kausel and Roesset 1992, J. Eng. Mech. 118) all this is done at s = i w +
// epsilon for exp(-epsilon t) g(t), and s has no zero.

#include "wavefield/signal/synthesis.hpp"

#include "base/require.hpp"
#include "wavefield/signal/phase_train.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

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

/// f(0) of the polynomial through f(1) .. f(6).
template <class Function>
Complex extrapolate_to_zero(Function f) {
  constexpr std::array<double, 6> weights = {6.0, -15.0, 20.0, -15.0, 6.0, -1.0};
  Complex sum = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k)
    sum += weights[k] * f(k + 1);
  return sum;
}

} // namespace

Synthesis::Synthesis(const FieldSetup& setup, const Window& window)
    : setup_(setup), window_(window), has_kink_(setup.has_kink()), fourier_(window.length),
      signal_(signal_spectrum(setup.signal, window, fourier_)) {}

void Synthesis::require_finite_displacement(const FieldSpectra& field) const {
  const auto response = field.static_response();
  const double out_of_phase = std::max(std::abs(response[0].imag()), std::abs(response[1].imag()));
  if (has_kink_ && out_of_phase * std::abs(signal_.offset) > 1e-6 * signal_.absolute_area) {
    throw std::invalid_argument("the signal leaves a displacement of " + shortest(signal_.offset) +
                                " m, must be 0 beyond the critical angle, and oblique in a half-space of "
                                "constant damping, where it would grow without end: remove "
                                "the offset of the motion");
  }
}

std::vector<History> Synthesis::sample(std::span<const Point> points, std::size_t count,
                                       const Quantities& quantities) {
  std::map<std::pair<std::size_t, double>, std::vector<std::size_t>> points_at;
  std::set<std::size_t> media;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t medium = setup_.medium_at(points[i]);
    points_at[{medium, points[i].y}].push_back(i);
    media.insert(medium);
  }
  const FieldSpectra field(setup_, signal_, std::vector<std::size_t>(media.begin(), media.end()));
  if (quantities.displacement)
    require_finite_displacement(field);
  std::vector<History> histories(points.size());
  DepthSpectra spectra;
  for (const auto& [place, at_place] : points_at) {
    field.at(place.second, place.first, quantities, spectra);
    for (const std::size_t i : at_place) {
      const double delay = field.slowness_x() * (points[i].x - setup_.incidence.x_reference);
      histories[i] = history(field, spectra, delay, count, quantities);
    }
  }
  return histories;
}

std::vector<double> Synthesis::on_grid(std::size_t count) {
  fourier_.inverse();
  const auto samples = fourier_.samples();
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = samples[window_.offset + i * window_.stride];
  if (window_.epsilon > 0.0) {
    for (std::size_t i = 0; i < count; ++i) {
      const double since_start = static_cast<double>(window_.offset + i * window_.stride) * window_.dt;
      values[i] *= std::exp(window_.epsilon * since_start);
    }
  }
  return values;
}

std::vector<double> Synthesis::series(const Spectrum& spectrum, const Spectrum& factors, std::size_t count) {
  const auto bins = fourier_.bins();
  for (std::size_t k = 0; k < spectrum.size(); ++k)
    bins[k] = times(factors[k], spectrum[k]);
  std::fill(bins.begin() + static_cast<std::ptrdiff_t>(spectrum.size()), bins.end(), Complex());
  if (has_kink_) {
    const auto weights = gregory_weights();
    bins[0] *= 2.0 * weights[0]; // the inverse transform counts bin 0 once, all others with their conjugates
    for (std::size_t k = 1; k < std::min(weights.size(), bins.size()); ++k)
      bins[k] *= weights[k];
  }
  return on_grid(count);
}

std::vector<double> Synthesis::displacement(const Spectrum& velocity, const Spectrum& shift, double delay,
                                            double static_response, std::size_t count) {
  const auto bins = fourier_.bins();
  std::fill(bins.begin(), bins.end(), Complex());
  if (window_.epsilon > 0.0) {
    for (std::size_t k = 0; k < velocity.size(); ++k)
      bins[k] = shift[k] * velocity[k] / window_.s(k);
    return on_grid(count);
  }

  const bool rest_from_start = !has_kink_ && std::abs(signal_.offset) > 1e-9 * signal_.absolute_area;
  double at_start = 0.0; // of the parts that are integrated from there
  const auto weights = gregory_weights();
  const std::size_t corrected = has_kink_ ? std::min(weights.size() + 1, velocity.size()) : 0;
  std::array<Complex, 7> low_rest{};
  for (std::size_t k = 1; k < velocity.size(); ++k) {
    const Complex factor = times(shift[k], 1.0 / window_.s(k));
    const Complex of_incident = times(factor, static_response * signal_.velocity[k]);
    bins[k] = times(factor, velocity[k]);
    const Complex rest = bins[k] - of_incident;
    if (k < corrected) {
      low_rest[k] = rest;
      bins[k] = of_incident + (k < weights.size() ? weights[k] : 1.0) * rest;
    }
    at_start += 2.0 * (of_incident.real() + (rest_from_start ? rest.real() : 0.0));
  }
  if (corrected == low_rest.size()) {
    // Seen from the signal's own time the spectrum turns slowly.
    const double centre = 0.5 * (setup_.signal.begin + setup_.signal.end) + delay - window_.start;
    bins[0] = 2.0 * weights[0] * extrapolate_to_zero([&](std::size_t k) {
                return low_rest[k] * std::polar(1.0, window_.omega(k) * centre);
              });
  }
  std::vector<double> values = on_grid(count);
  // The window's mean velocity, which a periodic function cannot integrate, is a ramp from its start.
  const double mean_velocity = static_response * signal_.velocity[0].real();
  for (std::size_t i = 0; i < count; ++i) {
    const double since_start = static_cast<double>(window_.offset + i * window_.stride) * window_.dt;
    values[i] += mean_velocity * since_start - at_start;
  }
  return values;
}

History Synthesis::history(const FieldSpectra& field, const DepthSpectra& spectra, double delay,
                           std::size_t count, const Quantities& quantities) {
  const std::size_t bins = spectra.vx.size();
  Spectrum& shift = shift_;
  shift.resize(bins);
  PhaseTrain train(-window_.s(0) * delay, (window_.s(0) - window_.s(1)) * delay);
  for (Complex& factor : shift)
    factor = train.next();
  History history;
  if (quantities.displacement) {
    const auto response = field.static_response();
    history.ux = displacement(spectra.vx, shift, delay, response[0].real(), count);
    history.uy = displacement(spectra.vy, shift, delay, response[1].real(), count);
  }
  if (quantities.velocity || quantities.strain)
    history.vx = series(spectra.vx, shift, count);
  if (quantities.strain) {
    history.exx = history.vx;
    for (double& strain : history.exx)
      strain *= -field.slowness_x();
    history.eyy = series(spectra.eyy, shift, count);
    history.gxy = series(spectra.gxy, shift, count);
  }
  if (quantities.velocity)
    history.vy = series(spectra.vy, shift, count);
  else
    history.vx.clear();
  if (quantities.stress) {
    history.sxx = series(spectra.sxx, shift, count);
    history.syy = series(spectra.syy, shift, count);
    history.sxy = series(spectra.sxy, shift, count);
  }
  if (!quantities.rates)
    return history;
  for (std::size_t k = 0; k < bins; ++k)
    shift[k] = times(shift[k], window_.s(k));
  if (quantities.velocity) {
    history.vx_rate = series(spectra.vx, shift, count);
    history.vy_rate = series(spectra.vy, shift, count);
  }
  if (quantities.stress) {
    history.sxx_rate = series(spectra.sxx, shift, count);
    history.syy_rate = series(spectra.syy, shift, count);
    history.sxy_rate = series(spectra.sxy, shift, count);
  }
  return history;
}

} // namespace tremolo::wavefield
