// Between its faces a layer's state is the sum of its four waves (reflectivity.cpp). With the sums P+ = P_up
// + P_down, P- = P_up - P_down of amplitudes at the depth, S likewise, and m the columns of the upgoing
// waves,
//
//     vx = m_00 P+ + m_01 S+      vy = m_10 P- + m_11 S-
//     sxy = -Z (m_20 P- + m_21 S-)      syy = -Z (m_30 P+ + m_31 S+).
//
// Strains and sxx follow from d/dx = -s p and Hooke's law, with G, M and lambda = M - 2 G of the layer:
//
//     exx = -p vx     gxy = sxy / G     eyy = (syy - lambda exx) / M     sxx = M exx + lambda eyy.

#include "wavefield/field_spectra.hpp"

#include "wavefield/phase_train.hpp"
#include "wavefield/require.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

/// Factors exp(s_k c_k), k = 0 .. count-1, multiplied into `values`; c_k = slowness(k) distance.
template <class Slowness>
void advance(Spectrum& values, const Window& window, bool constant, double distance, Slowness slowness) {
  if (constant) {
    const Complex delay = slowness(0) * distance;
    PhaseTrain phase(window.s(0) * delay, (window.s(1) - window.s(0)) * delay);
    for (Complex& value : values) {
      value = times(value, phase.next());
    }
    return;
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = times(values[k], std::exp(window.s(k) * slowness(k) * distance));
  }
}

} // namespace

double FieldSetup::top_of(std::size_t medium) const {
  double y = surface_level;
  for (std::size_t j = 0; j < medium; ++j) {
    y -= profile.layers[j].thickness;
  }
  return y;
}

std::size_t FieldSetup::medium_at(const Point& point) const {
  for (std::size_t j = 0; j < profile.layers.size(); ++j) {
    const double bottom = top_of(j + 1);
    // Levels are sums of thicknesses: an interface is met up to rounding.
    const bool on_it = std::abs(point.y - bottom) <= 1e-9 * profile.layers[j].thickness;
    if (on_it ? point.side == Side::above : point.y > bottom) {
      return j;
    }
  }
  return profile.layers.size();
}

bool FieldSetup::has_kink() const {
  const bool constant_damping = is_constant_damping(profile.damping.model);
  if (part == Part::incident) {
    return constant_damping && profile.half_space_damping > 0.0;
  }
  return (constant_damping && is_damped(profile)) || is_post_critical(profile.half_space, incidence);
}

SignalSpectrum signal_spectrum(const Signal& signal, const Window& window, RealFourier& fourier) {
  SignalSpectrum spectrum{.window = window, .velocity = {}};
  const auto samples = fourier.samples();
  for (std::size_t j = 0; j < window.length; ++j) {
    const double since_start = static_cast<double>(j) * window.dt;
    const double time = window.start + since_start;
    const double value = time >= signal.begin && time <= signal.end ? signal.velocity(time) : 0.0;
    require(std::isfinite(value), "velocity of the signal at t = " + shortest(time) + " s", value, "finite");
    spectrum.offset += value * window.dt;
    spectrum.absolute_area += std::abs(value) * window.dt;
    samples[j] = value * std::exp(-window.epsilon * since_start);
  }
  fourier.forward();
  const auto bins = fourier.bins();
  double largest = 0.0;
  for (const Complex& bin : bins) {
    largest = std::max(largest, std::abs(bin));
  }
  // Bins below rounding are not worth a phase at every depth.
  std::size_t band = bins.size();
  while (band > 1 && std::abs(bins[band - 1]) <= 1e-15 * largest) {
    --band;
  }
  spectrum.velocity.resize(band);
  for (std::size_t k = 0; k < band; ++k) {
    spectrum.velocity[k] = bins[k] / static_cast<double>(window.length);
  }
  return spectrum;
}

FieldSpectra::FieldSpectra(const FieldSetup& setup, const SignalSpectrum& signal,
                           std::span<const std::size_t> media)
    : window_(signal.window), part_(setup.part),
      reflectivity_(setup.profile, setup.incidence.wave, setup.incidence.angle_rad), static_{} {
  const std::size_t bins = signal.velocity.size();
  const bool constant = is_frequency_independent(setup.profile.damping.model);
  const double top_of_half_space = setup.top_of(reflectivity_.half_space());
  for (const std::size_t medium : media) {
    MediumWaves waves;
    waves.top = setup.top_of(medium);
    waves.bottom = medium == reflectivity_.half_space() ? top_of_half_space : setup.top_of(medium + 1);
    waves.bases.resize(constant ? 1 : bins);
    waves.moduli.resize(constant ? 1 : bins);
    for (std::size_t wave = 0; wave < 2; ++wave) {
      waves.up[wave].resize(bins);
      waves.down[wave].resize(bins);
    }
    media_.emplace(medium, std::move(waves));
  }
  for (std::size_t k = 0; k < bins; ++k) {
    const Complex s = window_.s(k);
    const std::vector<LayerAmplitudes>& amplitudes = reflectivity_.solve(s);
    // From the reference point to the top of the half-space.
    const Complex delay =
        reflectivity_.incident_slowness() * (setup.incidence.y_reference - top_of_half_space);
    const Complex incident = signal.velocity[k] * std::exp(s * delay);
    for (auto& [medium, waves] : media_) {
      fill(waves, medium, amplitudes[medium], incident, k);
    }
  }

  const LayerAmplitudes deep = reflectivity_.solve(0.0).back();
  const WaveBasis& basis = reflectivity_.basis(reflectivity_.half_space());
  Eigen::Vector4cd state = basis.up * deep.up;
  if (part_ == Part::total) {
    state += basis.down * deep.down;
  }
  static_ = {state[0], state[1]};
}

void FieldSpectra::fill(MediumWaves& waves, std::size_t medium, const LayerAmplitudes& amplitudes,
                        Complex incident, std::size_t bin) const {
  if (bin < waves.bases.size()) {
    waves.bases[bin] = reflectivity_.basis(medium);
    waves.moduli[bin] = reflectivity_.moduli(medium);
  }
  for (std::size_t wave = 0; wave < 2; ++wave) {
    const auto at = static_cast<Eigen::Index>(wave);
    waves.up[wave][bin] = incident * amplitudes.up[at];
    waves.down[wave][bin] = part_ == Part::total ? incident * amplitudes.down[at] : Complex();
  }
}

void FieldSpectra::propagate(const MediumWaves& waves, double y, std::array<Spectrum, 2>& up,
                             std::array<Spectrum, 2>& down) const {
  up = waves.up;
  down = waves.down;
  const bool constant = waves.bases.size() == 1;
  for (std::size_t wave = 0; wave < 2; ++wave) {
    const auto slowness = [&](std::size_t k) { return waves.bases[constant ? 0 : k].q[wave]; };
    advance(up[wave], window_, constant, waves.bottom - y, slowness);
    if (part_ == Part::total) {
      advance(down[wave], window_, constant, y - waves.top, slowness);
    }
  }
}

DepthSpectra FieldSpectra::at(double y, std::size_t medium, const Quantities& quantities) const {
  const MediumWaves& waves = media_.at(medium);
  std::array<Spectrum, 2> up;
  std::array<Spectrum, 2> down;
  propagate(waves, y, up, down);
  const std::size_t bins = up[0].size();
  const bool constant = waves.bases.size() == 1;
  const double z = reflectivity_.impedance();
  const double p = slowness_x();

  DepthSpectra spectra;
  spectra.vx.resize(bins);
  spectra.vy.resize(bins);
  for (Spectrum* stress : {&spectra.sxx, &spectra.syy, &spectra.sxy}) {
    stress->resize(quantities.stress ? bins : 0);
  }
  for (Spectrum* strain : {&spectra.eyy, &spectra.gxy}) {
    strain->resize(quantities.strain ? bins : 0);
  }
  WaveBasis::Columns m;
  Complex g, per_g, per_m, lambda, modulus;
  for (std::size_t k = 0; k < bins; ++k) {
    if (k == 0 || !constant) {
      m = waves.bases[k].up;
      g = waves.moduli[k].shear;
      modulus = waves.moduli[k].p_wave;
      lambda = modulus - 2.0 * g;
      per_g = 1.0 / g;
      per_m = 1.0 / modulus;
    }
    const Complex p_sum = up[0][k] + down[0][k];
    const Complex p_difference = up[0][k] - down[0][k];
    const Complex s_sum = up[1][k] + down[1][k];
    const Complex s_difference = up[1][k] - down[1][k];
    const Complex vx = times(m(0, 0), p_sum) + times(m(0, 1), s_sum);
    spectra.vx[k] = vx;
    spectra.vy[k] = times(m(1, 0), p_difference) + times(m(1, 1), s_difference);
    if (!quantities.stress && !quantities.strain) {
      continue;
    }
    const Complex sxy = -z * (times(m(2, 0), p_difference) + times(m(2, 1), s_difference));
    const Complex syy = -z * (times(m(3, 0), p_sum) + times(m(3, 1), s_sum));
    const Complex exx = -p * vx;
    const Complex eyy = times(syy - times(lambda, exx), per_m);
    if (quantities.stress) {
      spectra.sxy[k] = sxy;
      spectra.syy[k] = syy;
      spectra.sxx[k] = times(modulus, exx) + times(lambda, eyy);
    }
    if (quantities.strain) {
      spectra.eyy[k] = eyy;
      spectra.gxy[k] = times(sxy, per_g);
    }
  }
  return spectra;
}

} // namespace tremolo::wavefield
