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

#include "wavefield/layers/field_spectra.hpp"

#include "base/require.hpp"
#include "wavefield/signal/phase_train.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

/// Factors that bring the waves of a medium, P and SV, up and down, from the faces where they enter to a
/// level.
struct Propagation {
  std::array<Complex, 2> up, down;
};

/// Propagation at bins 0, 1, 2, ...: geometric sequences where the slownesses do not depend on frequency.
class PropagationTrain {
public:
  PropagationTrain(const Window& window, const WaveBasis& basis, double up, double down)
      : p_up_(train(window, basis.q[0] * up)), s_up_(train(window, basis.q[1] * up)),
        p_down_(train(window, basis.q[0] * down)), s_down_(train(window, basis.q[1] * down)) {}

  Propagation next() { return {{p_up_.next(), s_up_.next()}, {p_down_.next(), s_down_.next()}}; }

private:
  static PhaseTrain train(const Window& window, Complex delay) {
    return {-window.s(0) * delay, (window.s(0) - window.s(1)) * delay};
  }
  PhaseTrain p_up_, s_up_, p_down_, s_down_;
};

Propagation propagation(Complex s, const WaveBasis& basis, double up, double down) {
  return {{std::exp(-s * basis.q[0] * up), std::exp(-s * basis.q[1] * up)},
          {std::exp(-s * basis.q[0] * down), std::exp(-s * basis.q[1] * down)}};
}

} // namespace

double FieldSetup::top_of(std::size_t medium) const {
  double y = surface_level;
  for (std::size_t j = 0; j < medium; ++j)
    y -= profile.layers[j].thickness;
  return y;
}

std::size_t FieldSetup::medium_at(const Point& point) const {
  // The incident wave is known in the half-space alone, whose top belongs to it then.
  const Side side = part == Part::incident ? Side::below : point.side;
  for (std::size_t j = 0; j < profile.layers.size(); ++j) {
    const double bottom = top_of(j + 1);
    // Levels are sums of thicknesses: an interface is met up to rounding.
    const bool on_it = std::abs(point.y - bottom) <= 1e-9 * profile.layers[j].thickness;
    if (on_it ? side == Side::above : point.y > bottom)
      return j;
  }
  return profile.layers.size();
}

bool FieldSetup::has_kink() const {
  const bool jumps = jumps_at_zero_frequency(profile.damping.model);
  if (part == Part::incident)
    return jumps && profile.half_space_damping > 0.0;
  return (jumps && is_damped(profile)) || is_post_critical(profile.half_space, incidence);
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
  for (const Complex& bin : bins)
    largest = std::max(largest, std::abs(bin));
  // Bins below rounding are not worth a phase at every depth.
  std::size_t band = bins.size();
  while (band > 1 && std::abs(bins[band - 1]) <= 1e-15 * largest)
    --band;
  spectrum.velocity.resize(band);
  for (std::size_t k = 0; k < band; ++k)
    spectrum.velocity[k] = bins[k] / static_cast<double>(window.length);
  return spectrum;
}

FieldSpectra::FieldSpectra(const FieldSetup& setup, const SignalSpectrum& signal,
                           std::span<const std::size_t> media)
    : window_(signal.window), part_(setup.part), wave_(setup.incidence.wave),
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
    if (setup.profile.damping.model == DampingModel::rayleigh && part_ == Part::total)
      waves.carried.resize(bins);
    media_.emplace(medium, std::move(waves));
  }
  for (std::size_t k = 0; k < bins; ++k) {
    const Complex s = window_.s(k);
    const std::vector<LayerAmplitudes>& amplitudes = reflectivity_.solve(s);
    // Delay from the reference point to the top of the half-space.
    const Complex delay =
        reflectivity_.incident_slowness() * (setup.incidence.y_reference - top_of_half_space);
    const Complex incident = signal.velocity[k] * std::exp(s * delay);
    for (auto& [medium, waves] : media_)
      fill(waves, medium, amplitudes[medium], incident, k);
  }

  const LayerAmplitudes deep = reflectivity_.solve(0.0).back();
  const WaveBasis& basis = reflectivity_.basis(reflectivity_.half_space());
  Eigen::Vector4cd state = basis.up * deep.up;
  if (part_ == Part::total)
    state += basis.down * deep.down;
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
  if (!waves.carried.empty())
    waves.carried[bin] = incident * amplitudes.carried;
}

void FieldSpectra::at(double y, std::size_t medium, const Quantities& quantities,
                      DepthSpectra& spectra) const {
  const MediumWaves& waves = media_.at(medium);
  const std::size_t bins = waves.up[0].size();
  const bool constant = waves.bases.size() == 1;
  const double from_bottom = y - waves.bottom;
  const double from_top = waves.top - y;
  const double z = reflectivity_.impedance();
  const double p = slowness_x();
  for (Spectrum* velocity : {&spectra.vx, &spectra.vy})
    velocity->resize(bins);
  for (Spectrum* stress : {&spectra.sxx, &spectra.syy, &spectra.sxy})
    stress->resize(quantities.stress ? bins : 0);
  for (Spectrum* strain : {&spectra.eyy, &spectra.gxy})
    strain->resize(quantities.strain ? bins : 0);
  PropagationTrain train(window_, waves.bases.front(), from_bottom, from_top);
  WaveBasis::Columns m;
  Complex per_g, per_m, lambda, modulus;
  for (std::size_t k = 0; k < bins; ++k) {
    if (k == 0 || !constant) {
      m = waves.bases[k].up;
      modulus = waves.moduli[k].p_wave;
      lambda = modulus - 2.0 * waves.moduli[k].shear;
      per_g = 1.0 / waves.moduli[k].shear;
      per_m = 1.0 / modulus;
    }
    const Propagation to =
        constant ? train.next() : propagation(window_.s(k), waves.bases[k], from_bottom, from_top);
    const Complex p_up = times(to.up[0], waves.up[0][k]);
    const Complex s_up = times(to.up[1], waves.up[1][k]);
    const bool total = part_ == Part::total;
    const Complex p_down = total ? times(to.down[0], waves.down[0][k]) : Complex();
    const Complex s_down = total ? times(to.down[1], waves.down[1][k]) : Complex();
    const Complex vx = times(m(0, 0), p_up + p_down) + times(m(0, 1), s_up + s_down);
    spectra.vx[k] = vx;
    spectra.vy[k] = times(m(1, 0), p_up - p_down) + times(m(1, 1), s_up - s_down);
    if (!waves.carried.empty())
      (wave_ == WaveType::SV ? spectra.vx : spectra.vy)[k] += waves.carried[k];
    if (!quantities.stress && !quantities.strain)
      continue;
    const Complex sxy = -z * (times(m(2, 0), p_up - p_down) + times(m(2, 1), s_up - s_down));
    const Complex syy = -z * (times(m(3, 0), p_up + p_down) + times(m(3, 1), s_up + s_down));
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
}

} // namespace tremolo::wavefield
