// Iteration: the profile with the moduli of the last strains is linear; it gives every layer's gamma_xy(t) at
// mid-depth; the effective strain is 0.65 (or what is asked for) of its largest value; the curves give G and
// xi for the next pass (Schnabel, Lysmer and Seed 1972, SHAKE, EERC 72-12).
//
// gamma_xy = (-i w) (p v + q u) of the incident velocity's waves at depth, that is sxy / G: the spectrum of
// the incident velocity, acceleration / (i w), times the state of the layer at mid-depth.
//
// Where a motion recorded in the ground is given, the incident one is that of each pass's own profile
// (recorded_motion.cpp), as SHAKE does where the object motion is not at the base.

#include "wavefield/layers/equivalent_linear.hpp"

#include "base/require.hpp"
#include "wavefield/layers/recorded_motion.hpp"
#include "wavefield/layers/reflectivity.hpp"
#include "wavefield/signal/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tremolo::wavefield {
namespace {

using Complex = std::complex<double>;

/// Spectrum of the incident velocity, bins k / (length dt).
struct IncidentVelocity {
  double dt = 0.0;
  std::size_t length = 0;
  std::vector<Complex> bins;

  Complex s(std::size_t k) const {
    return {0.0, 2.0 * std::numbers::pi * static_cast<double>(k) / (static_cast<double>(length) * dt)};
  }
};

/// Zero-padded to twice the record's length, like the powers of two that SHAKE takes.
IncidentVelocity incident_velocity(const IncidentAcceleration& motion) {
  IncidentVelocity velocity{.dt = motion.dt, .length = fast_length(2 * motion.samples.size()), .bins = {}};
  RealFourier fourier(velocity.length);
  const auto samples = fourier.samples();
  std::fill(std::copy(motion.samples.begin(), motion.samples.end(), samples.begin()), samples.end(), 0.0);
  fourier.forward();
  velocity.bins.assign(fourier.bins().begin(), fourier.bins().end());
  velocity.bins[0] = 0.0; // a mean velocity strains nothing
  for (std::size_t k = 1; k < velocity.bins.size(); ++k)
    velocity.bins[k] /= velocity.s(k) * static_cast<double>(velocity.length);
  return velocity;
}

/// Velocity of the incident wave that makes the ground move as recorded.
IncidentVelocity incident_velocity(const RecordedMotion& record, const LayeredHalfSpace& profile,
                                   WaveType wave, double angle_rad) {
  IncidentVelocity velocity{.dt = record.dt, .length = fast_length(2 * record.samples.size()), .bins = {}};
  velocity.bins = incident_spectrum(profile, wave, angle_rad, record, velocity.length).bins;
  velocity.bins[0] = 0.0;
  for (std::size_t k = 1; k < velocity.bins.size(); ++k)
    velocity.bins[k] /= velocity.s(k);
  return velocity;
}

/// Largest |gamma_xy| over time at mid-depth of every layer.
std::vector<double> strains_under(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                  const IncidentVelocity& velocity) {
  const std::size_t layers = profile.layers.size();
  Reflectivity reflectivity(profile, wave, angle_rad);
  std::vector<std::vector<Complex>> strain(layers, std::vector<Complex>(velocity.bins.size()));
  for (std::size_t k = 1; k < velocity.bins.size(); ++k) {
    if (velocity.bins[k] == 0.0) // above a record's cutoff
      continue;
    const Complex s = velocity.s(k);
    const auto& amplitudes = reflectivity.solve(s);
    for (std::size_t j = 0; j < layers; ++j) {
      const WaveBasis& basis = reflectivity.basis(j);
      const double half = 0.5 * profile.layers[j].thickness;
      const Complex to_p = std::exp(-s * basis.q[0] * half);
      const Complex to_s = std::exp(-s * basis.q[1] * half);
      const Complex sxy = basis.up(2, 0) * to_p * (amplitudes[j].up[0] - amplitudes[j].down[0]) +
                          basis.up(2, 1) * to_s * (amplitudes[j].up[1] - amplitudes[j].down[1]);
      strain[j][k] = -reflectivity.impedance() * sxy / reflectivity.moduli(j).shear * velocity.bins[k];
    }
  }
  RealFourier fourier(velocity.length);
  std::vector<double> largest(layers);
  for (std::size_t j = 0; j < layers; ++j) {
    std::copy(strain[j].begin(), strain[j].end(), fourier.bins().begin());
    fourier.inverse();
    for (const double value : fourier.samples())
      largest[j] = std::max(largest[j], std::abs(value));
  }
  return largest;
}

double relative_change(double before, double after) {
  return before == after ? 0.0 : std::abs(after - before) / std::max(std::abs(after), std::abs(before));
}

/// Update of a layer in an iteration.
struct Softening {
  double modulus_change = 0.0; ///< relative
  double damping_change = 0.0; ///< relative
  bool held_damping = false;
};

/// Gives a layer the modulus and damping ratio of its effective strain.
Softening soften(Layer& layer, const Layer& at_small_strain, const StrainCurves& curves, double strain,
                 const std::string& which) {
  const double reduction = curves.modulus_reduction(strain);
  const double wanted = curves.damping(strain);
  require(reduction > 0.0 && reduction <= 1.0, "G/Gmax of " + which + " at a strain of " + shortest(strain),
          reduction, "in (0, 1]");
  require(wanted >= 0.0 && wanted < 1.0, "damping ratio of " + which + " at a strain of " + shortest(strain),
          wanted, "in [0, 1)");
  const double damping = std::min(wanted, largest_damping);
  const double before = std::pow(layer.vs / at_small_strain.vs, 2);
  const Softening softening{.modulus_change = relative_change(before, reduction),
                            .damping_change = relative_change(layer.damping, damping),
                            .held_damping = damping < wanted};
  // The curves are of the shear modulus; the bulk modulus K stays, with its damping at small strain. The
  // moduli below are over the density: rho c_p^2 = K + 4/3 G.
  const double shear = 4.0 / 3.0 * at_small_strain.vs * at_small_strain.vs * reduction;
  const double bulk = at_small_strain.vp * at_small_strain.vp - shear / reduction;
  layer.vs = at_small_strain.vs * std::sqrt(reduction);
  layer.vp = std::sqrt(bulk + shear);
  layer.damping = damping;
  layer.damping_p = (bulk * at_small_strain.damping + shear * damping) / (bulk + shear);
  return softening;
}

void validate(const LayeredHalfSpace& profile, std::span<const StrainCurves> curves,
              const EquivalentLinearOptions& options) {
  validate(profile);
  if (profile.layers.empty())
    throw std::invalid_argument("an equivalent linear analysis needs at least one layer");
  if (curves.size() != profile.layers.size()) {
    throw std::invalid_argument("curves of " + std::to_string(curves.size()) + " layers, must be " +
                                std::to_string(profile.layers.size()) + ", one a layer");
  }
  if (profile.damping.model == DampingModel::none)
    throw std::invalid_argument("an equivalent linear analysis needs a damping model, not `none`");
  require(options.strain_ratio > 0.0 && options.strain_ratio <= 1.0, "ratio of effective to largest strain",
          options.strain_ratio, "in (0, 1]");
  require(options.tolerance > 0.0 && options.tolerance < 1.0, "tolerance", options.tolerance, "in (0, 1)");
  require(options.max_iterations >= 1, "number of iterations", options.max_iterations, "at least 1");
}

void validate(const IncidentAcceleration& motion) {
  if (motion.samples.size() < 2) {
    throw std::invalid_argument("an incident motion of " + std::to_string(motion.samples.size()) +
                                " samples, must be at least 2");
  }
  for (const double value : motion.samples)
    require(std::isfinite(value), "a sample of the incident acceleration", value, "finite");
  require_positive("time step of the incident acceleration", motion.dt, "s");
}

/// Largest strain of each layer of a profile.
using Strains = std::function<std::vector<double>(const LayeredHalfSpace&)>;

EquivalentLinearResult iterated(const LayeredHalfSpace& profile, std::span<const StrainCurves> curves,
                                const Strains& strains, const EquivalentLinearOptions& options) {
  EquivalentLinearResult result{.profile = profile, .iterations = {}};
  std::size_t slowest = 0;
  for (int i = 0; i < options.max_iterations && !result.converged; ++i) {
    EquivalentLinearIteration iteration;
    iteration.largest_strain = strains(result.profile);
    result.held_damping.clear();
    double largest_change = 0.0;
    for (std::size_t j = 0; j < curves.size(); ++j) {
      const Softening softening =
          soften(result.profile.layers[j], profile.layers[j], curves[j],
                 options.strain_ratio * iteration.largest_strain[j], depth_range(profile, j));
      iteration.modulus_change = std::max(iteration.modulus_change, softening.modulus_change);
      iteration.damping_change = std::max(iteration.damping_change, softening.damping_change);
      if (softening.held_damping)
        result.held_damping.push_back(j);
      const double change = std::max(softening.modulus_change, softening.damping_change);
      if (change > largest_change) {
        largest_change = change;
        slowest = j;
      }
    }
    result.converged = largest_change <= options.tolerance;
    result.iterations.push_back(std::move(iteration));
  }
  if (!result.converged && !options.allow_non_convergence) {
    const EquivalentLinearIteration& last = result.iterations.back();
    throw NotConverged(
        "the equivalent linear analysis has not converged after " + std::to_string(options.max_iterations) +
        " iterations: modulus still changes by " + shortest(100.0 * last.modulus_change) + " %, damping by " +
        shortest(100.0 * last.damping_change) + " %, most in " + depth_range(profile, slowest) +
        "; allowed is " + shortest(100.0 * options.tolerance) + " %");
  }
  return result;
}

} // namespace

std::string depth_range(const LayeredHalfSpace& profile, std::size_t layer) {
  double top = 0.0;
  for (std::size_t j = 0; j < layer; ++j)
    top += profile.layers[j].thickness;
  const auto rounded = [](double depth) { return shortest(std::round(1e3 * depth) / 1e3); };
  return "the soil from " + rounded(top) + " m to " + rounded(top + profile.layers[layer].thickness) +
         " m below the surface";
}

std::vector<double> largest_strains(const LayeredHalfSpace& profile, WaveType wave, double angle_rad,
                                    const RecordedMotion& record) {
  validate(profile);
  validate(record, profile);
  return strains_under(profile, wave, angle_rad, incident_velocity(record, profile, wave, angle_rad));
}

EquivalentLinearResult equivalent_linear(const LayeredHalfSpace& profile,
                                         std::span<const StrainCurves> curves, WaveType wave,
                                         double angle_rad, const IncidentAcceleration& motion,
                                         const EquivalentLinearOptions& options) {
  validate(profile, curves, options);
  validate(motion);
  const IncidentVelocity velocity = incident_velocity(motion);
  return iterated(
      profile, curves,
      [&](const LayeredHalfSpace& ground) { return strains_under(ground, wave, angle_rad, velocity); },
      options);
}

EquivalentLinearResult equivalent_linear_under_record(const LayeredHalfSpace& profile,
                                                      std::span<const StrainCurves> curves, WaveType wave,
                                                      double angle_rad, const RecordedMotion& record,
                                                      const EquivalentLinearOptions& options) {
  validate(profile, curves, options);
  validate(record, profile);
  return iterated(
      profile, curves,
      [&](const LayeredHalfSpace& ground) {
        auto strains =
            strains_under(ground, wave, angle_rad, incident_velocity(record, ground, wave, angle_rad));
        for (std::size_t j = 0; j < strains.size(); ++j)
          if (!(strains[j] <= 1.0))
            throw std::runtime_error(
                "the equivalent linear analysis runs away: " + depth_range(ground, j) + " would strain by " +
                shortest(100.0 * strains[j]) +
                " %, so that no motion from below gives the recorded one; a lower cutoff "
                "asks for less");
        return strains;
      },
      options);
}

} // namespace tremolo::wavefield
