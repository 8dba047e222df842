// Hard case 13: levels with steps of their own, up to the limit, over 5000 steps of the coarsest. Forces that
// come as impulses every other step can be in resonance with the motion of the fine cells, which shows after
// hundreds of steps only.

#include "mpm_domain/step/stepper.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/hard_case.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/particle_energy.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr long coarse_steps = 5000;

/// A periodic strip, free at both ends, its upper part of ever finer cells; the finest 2^levels times smaller
/// than the coarsest.
Spec strip(int levels, double fraction) {
  Spec spec = test_support::elastic_box(2.0, 8.0 + 4.0 * levels, 1.0);
  spec.sides = mpm_domain::Sides::periodic;
  for (int level = 1; level <= levels; ++level)
    spec.refine.push_back({{0.0, -(1.0 + 3.0 * (levels - level)), 2.0, 0.0}, level});
  spec.scheme.fraction = fraction;
  spec.scheme.subcycle = true;
  spec.threads = 1;
  return spec;
}

/// Waves and noise of 1 mm/s. The strip lies a little beside the mesh: no node has next to no mass.
void set_moving(Domain& domain) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      set.vx[k] = 1e-3 * (noise(random) + std::cos(set.y[k]));
      set.vy[k] = 1e-3 * (noise(random) + std::sin(2.0 * set.y[k]));
      set.y[k] -= 0.031;
    }
  sort_particles(domain);
}

Vector momentum(const Domain& domain) {
  Vector sum;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      sum.x += set.mass[k] * set.vx[k];
      sum.y += set.mass[k] * set.vy[k];
    }
  return sum;
}

struct Outcome {
  double energy = 0.0;   ///< largest over that at the start
  double momentum = 0.0; ///< change over sum m |v| of the start
};

Outcome outcome_of(const Spec& spec) {
  Domain domain(spec);
  set_moving(domain);
  const double start = test_support::particle_energy(domain);
  const Vector before = momentum(domain);
  double scale = 0.0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      scale += set.mass[k] * std::hypot(set.vx[k], set.vy[k]);
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  Outcome outcome;
  for (long step = 1; step <= coarse_steps; ++step) {
    stepper.step();
    if (step % 10 == 0)
      outcome.energy = std::max(outcome.energy, test_support::particle_energy(domain) / start);
  }
  const Vector after = momentum(domain);
  outcome.momentum = std::hypot(after.x - before.x, after.y - before.y) / scale;
  return outcome;
}

class HardCase13Subcycling : public testing::TestWithParam<int> {};

/// The limit of the scheme, 0.65 h/c, is 0.87 of the critical step of these cells, 0.746 h/c.
TEST_P(HardCase13Subcycling, SubcyclingIsStableAtAnyStepUpToTheLimit) {
  const int levels = GetParam();
  Outcome worst;
  for (const double fraction : {0.35, 0.5, 0.65, 0.8, 0.9, 0.975}) {
    const Outcome outcome = outcome_of(strip(levels, fraction));
    worst.energy = std::max(worst.energy, outcome.energy);
    worst.momentum = std::max(worst.momentum, outcome.momentum);
  }
  test_support::bounded(fmt::format("m = {}: largest energy over that at the start", 1 << levels),
                        worst.energy, 1.1);
  test_support::bounded(fmt::format("m = {}: change of momentum over the sum of m times speed", 1 << levels),
                        worst.momentum, 1e-10);
}

std::string name_of(const testing::TestParamInfo<int>& levels) {
  return fmt::format("m{}", 1 << levels.param);
}

INSTANTIATE_TEST_SUITE_P(Levels, HardCase13Subcycling, testing::Values(1), name_of);
INSTANTIATE_TEST_SUITE_P(AcceptanceLevels, HardCase13Subcycling, testing::Values(2, 3), name_of);

/// The impulses alone, without what particles and grid damp in their exchange: a chain of 24 cells of size 1
/// and 24 of size 1/m, density and modulus 1, after the same number of steps. `buffer` coarse cells run on
/// the fast clock.
double growth_of_chain(int m, double fraction, int buffer) {
  constexpr std::size_t each = 24;
  std::vector<double> h, mass(2 * each + 1, 0.0);
  std::vector<bool> slow;
  for (std::size_t e = 0; e < 2 * each; ++e) {
    h.push_back(e < each ? 1.0 / m : 1.0);
    slow.push_back(e >= each + static_cast<std::size_t>(buffer));
    mass[e] += 0.5 * h[e];
    mass[e + 1] += 0.5 * h[e];
  }
  std::vector<double> u(mass.size(), 0.0), v;
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  for (std::size_t n = 0; n < mass.size(); ++n)
    v.push_back(noise(random));
  const auto energy_now = [&] {
    double sum = 0.0;
    for (std::size_t n = 0; n < mass.size(); ++n)
      sum += 0.5 * mass[n] * v[n] * v[n];
    for (std::size_t e = 0; e < h.size(); ++e)
      sum += 0.5 / h[e] * (u[e + 1] - u[e]) * (u[e + 1] - u[e]);
    return sum;
  };
  const double start = energy_now();
  const double dt = fraction / m;
  double largest = 0.0;
  for (long tick = 0; tick < coarse_steps * m; ++tick) {
    for (std::size_t e = 0; e < h.size(); ++e) {
      if (slow[e] && tick % m != 0)
        continue;
      const double pull = (slow[e] ? m * dt : dt) * (u[e + 1] - u[e]) / h[e];
      v[e] += pull / mass[e];
      v[e + 1] -= pull / mass[e + 1];
    }
    for (std::size_t n = 0; n < u.size(); ++n)
      u[n] += dt * v[n];
    if (tick % m == m - 1)
      largest = std::max(largest, energy_now() / start);
  }
  return largest;
}

/// m = 2 from level to level. The energy that a leapfrog keeps is not that of one time level: it swings more
/// the nearer the limit is.
TEST(HardCase13SubcycledChain, TwoLayersOfBufferTakeTheResonanceAway) {
  double worst = 0.0;
  double without = 0.0;
  for (const double fraction : {0.5, 0.65, 0.78, 0.8, 0.82, 0.85}) {
    worst = std::max(worst, growth_of_chain(2, fraction, 2) / growth_of_chain(1, fraction, 0));
    without = std::max(without, growth_of_chain(2, fraction, 0) / growth_of_chain(1, fraction, 0));
  }
  test_support::bounded("chain: largest energy over that of a single step", worst, 2.0);
  test_support::breaks("no buffer", without, 2.0);
}

} // namespace
} // namespace tremolo::mpm_domain
