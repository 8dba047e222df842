// Constant damping in the domain: standing waves between two free faces, cos(k y) with k = n pi/H, decay as
// exp(s t), where s is the root of
//
//     rho s^2 + k^2 M*(s) = 0,    M* = M F(s),    F the factor of materials/relaxation/relaxation.cpp,
//
// near i k c: at the same ratio -Re s/|s| whatever the frequency, S and P alike.

#include "materials/relaxation/constant_damping.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using Complex = std::complex<double>;

constexpr double depth = 16.0; // m
constexpr double h = 0.5;
constexpr double amplitude = 1e-4; // m/s: strains of 1e-6
constexpr double ratio = 0.05;
const materials::Elasticity soil{1700.0, 40e6, 0.28};

materials::Relaxation damping() {
  return materials::relaxation({3.0, {}}, ratio);
}

struct StandingWave {
  bool shear = true;
  int half_waves = 1;

  double wave_number() const { return half_waves * std::numbers::pi / depth; }
  double speed() const { return shear ? soil.s_wave_speed() : soil.p_wave_speed(); }
  /// s, 1/s
  Complex root() const {
    Complex s(0.0, wave_number() * speed());
    for (int n = 0; n < 100; ++n)
      s = Complex(0.0, wave_number() * speed()) * std::sqrt(damping().factor(s));
    return s;
  }
};

Spec strip(const materials::Law& law = materials::LinearElastic{soil}) {
  Spec spec = test_support::elastic_box(2.0, depth, h);
  spec.sides = Sides::periodic;
  spec.soils.front().law = law;
  spec.soils.front().relaxation = damping();
  return spec;
}

/// Decay and frequency of the modal velocity, from its later extremes, and the ledger.
struct Decay {
  double ratio = 0.0;
  double period = 0.0;
  double residual = 0.0; ///< largest, over the energy at the start
  EnergyLedger energy;   ///< at the end
};

Decay run(Domain& domain, const StandingWave& wave, double periods, double peak = amplitude) {
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      (wave.shear ? set.vx : set.vy)[k] = peak * std::cos(wave.wave_number() * (set.y[k] + depth));
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  std::vector<double> time, velocity;
  Decay decay;
  while (stepper.time() < periods * 2.0 * std::numbers::pi / std::abs(wave.root())) {
    stepper.step();
    double sum = 0.0;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        sum += set.mass[k] * std::cos(wave.wave_number() * (set.y_initial[k] + depth)) *
               (wave.shear ? set.vx : set.vy)[k];
    time.push_back(stepper.velocity_time());
    velocity.push_back(sum);
    decay.residual = std::max(decay.residual, std::abs(domain.energy.residual()));
  }
  std::vector<double> extremes, when;
  for (std::size_t n = 1; n + 1 < velocity.size(); ++n) {
    const double slope = 0.5 * (velocity[n + 1] - velocity[n - 1]);
    const double curvature = velocity[n + 1] - 2.0 * velocity[n] + velocity[n - 1];
    if ((velocity[n] - velocity[n - 1]) * (velocity[n + 1] - velocity[n]) <= 0.0 && curvature != 0.0) {
      extremes.push_back(std::abs(velocity[n] - 0.5 * slope * slope / curvature));
      when.push_back(time[n] - slope / curvature * (time[n] - time[n - 1]));
    }
  }
  const auto count = static_cast<double>(extremes.size() - 3);
  const double decrement = std::log(extremes[2] / extremes.back()) / count / std::numbers::pi;
  decay.ratio = decrement / std::hypot(1.0, decrement);
  decay.period = 2.0 * (when.back() - when[2]) / count;
  decay.energy = domain.energy;
  decay.residual /= domain.energy.kinetic_start;
  return decay;
}

class ConstantDampingOfTheDomain : public testing::TestWithParam<std::tuple<bool, int>> {};

/// Waves of 3.1 and 6.1 Hz (S), 5.6 and 11 Hz (P). The ratio of a free decay is not that of a steady cycle:
/// of Kjartansson's solid, M* as s^g, g = 2 atan(2 xi)/pi, it is sin(atan(2 xi)/(2 - g)).
TEST_P(ConstantDampingOfTheDomain, HasTheSameRatioAtAllFrequencies) {
  const StandingWave wave{std::get<0>(GetParam()), std::get<1>(GetParam())};
  Domain domain(strip());
  Spec same_step = strip();
  same_step.soils.front().relaxation = {};
  same_step.scheme.fraction /= std::sqrt(damping().unrelaxed());
  Domain undamped(same_step);
  const Decay decay = run(domain, wave, 5.0), without = run(undamped, wave, 5.0);
  const Complex s = wave.root();
  const double exact = -s.real() / std::abs(s);
  const double kjartansson =
      std::sin(std::atan(2.0 * ratio) / (2.0 - 2.0 * std::atan(2.0 * ratio) / std::numbers::pi));
  std::printf("%.2f Hz: ratio %.5f, exact %.5f, Kjartansson %.5f; period over exact %.5f; residual %.1e, "
              "undamped %.1e\n",
              std::abs(s) / (2.0 * std::numbers::pi), decay.ratio, exact, kjartansson,
              decay.period * s.imag() / (2.0 * std::numbers::pi), decay.residual, without.residual);
  EXPECT_NEAR(decay.ratio / exact, 1.0, 0.01);
  EXPECT_NEAR(decay.ratio / kjartansson, 1.0, 0.02);
  EXPECT_NEAR(decay.period * s.imag() / (2.0 * std::numbers::pi), 1.0, 5e-3);
  EXPECT_LT(decay.residual, 1.1 * without.residual);
  const double lost = 1.0 - (decay.energy.kinetic + decay.energy.elastic) / decay.energy.kinetic_start;
  EXPECT_NEAR(decay.energy.viscous / decay.energy.kinetic_start, lost, 0.04);
}

INSTANTIATE_TEST_SUITE_P(Waves, ConstantDampingOfTheDomain,
                         testing::Combine(testing::Bool(), testing::Values(1, 2)));

/// Particles cross to cells of half the size half way up, which step twice as often: coefficients are those
/// of their own step. What the transfers between levels damp by themselves comes on top.
TEST(ConstantDampingOnLevels, HasItsRatioWithStepsOfTheLevelsOwn) {
  const StandingWave wave{true, 1};
  Spec spec = strip();
  spec.refine = {{{0.0, -0.5 * depth, 2.0, 0.0}, 1}};
  spec.scheme.subcycle = true;
  Domain domain(spec);
  spec.soils.front().relaxation = {};
  Domain undamped(spec);
  const Decay with = run(domain, wave, 3.0), without = run(undamped, wave, 3.0);
  const Complex s = wave.root();
  std::printf("ratio %.5f, without %.5f, exact %.5f\n", with.ratio, without.ratio, -s.real() / std::abs(s));
  EXPECT_NEAR((with.ratio - without.ratio) * std::abs(s) / -s.real(), 1.0, 0.02);
}

/// The shear stress of the wave, rho c v, is twice what the clay bears, elastic until it yields. Mechanisms
/// have then taken up their shares of its strength and no more, G_U/G_R of it together, and let go of them.
TEST(ConstantDampingOfClayThatYields, BearsNoMoreThanTheSharesOfItsStrength) {
  constexpr double cohesion = 8.0; // Pa
  materials::MohrCoulomb clay;
  clay.elastic = soil;
  clay.cohesion_peak = clay.cohesion_residual = cohesion;
  const StandingWave wave{true, 1};
  Domain domain(strip(clay));
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.vx[k] = 1.5 * amplitude * std::cos(wave.wave_number() * (set.y[k] + depth));
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  double largest = 0.0;
  while (stepper.time() < 0.3) {
    stepper.step();
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        largest = std::max(largest, std::abs(set.sxy[k] + set.viscous_xy[k]));
  }
  std::printf("largest shear stress over cohesion %.3f\n", largest / cohesion);
  EXPECT_LT(largest, damping().unrelaxed() / damping().relaxed * cohesion);
  const EnergyLedger& energy = domain.energy;
  EXPECT_GT(energy.plastic, 0.1 * energy.kinetic_start);
  EXPECT_NEAR((energy.plastic + energy.viscous + energy.kinetic + energy.elastic) / energy.kinetic_start, 1.0,
              0.02);
}

/// The critical step is that of the stiffness G_U: a column of strongly damped soil with noise neither grows
/// at it.
TEST(ConstantDampingOfTheDomain, IsStableAtItsLimit) {
  Spec spec = strip();
  spec.soils.front().relaxation = materials::relaxation({3.0, {}}, 0.2);
  spec.scheme.fraction = 0.99;
  Domain domain(spec);
  const Decay decay = run(domain, {true, 8}, 30.0);
  EXPECT_LT(decay.energy.kinetic, 1e-3 * decay.energy.kinetic_start);
}

} // namespace
} // namespace tremolo::mpm_domain
