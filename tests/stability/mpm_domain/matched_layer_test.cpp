// Matched layers over a long time: many steps after a blow, many seconds under self weight, and beside soil
// that yields.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/particle_energy.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo {
namespace {

using mpm_domain::Side;

/// Every particle gets a velocity of its own, up to 1 m/s: waves of all lengths and directions.
void strike(mpm_domain::Domain& domain) {
  for (mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double number = static_cast<double>(set.id[k]);
      set.vx[k] = std::sin(12.9898 * number);
      set.vy[k] = std::cos(78.233 * number);
    }
}

double largest_displacement(const mpm_domain::Domain& domain) {
  double largest = 0.0;
  for (const mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      largest = std::max(largest, std::hypot(set.x[k] - set.x_initial[k], set.y[k] - set.y_initial[k]));
  return largest;
}

/// The energy is that of the particles: the kinetic energy of the grid also has what stresses in the null
/// space, which never reach a particle's velocity, do to the nodes in every step anew.
void expect_quiet(long steps) {
  mpm_domain::Spec spec = test_support::elastic_box(12.0, 8.0, 1.0);
  spec.threads = 1;
  spec.matched_sides = {Side::left, Side::right, Side::base};
  spec.scheme.fraction = 0.95;
  mpm_domain::Domain domain(spec);
  strike(domain);
  mpm_domain::Stepper stepper(domain, 0.0, test_support::quiet_ground());
  stepper.step();
  const double before = test_support::kinetic_energy(domain);
  double after_a_tenth = 0.0;
  for (long step = 1; step < steps; ++step) {
    stepper.step();
    if (step == 10000)
      after_a_tenth = test_support::kinetic_energy(domain);
  }
  EXPECT_LT(after_a_tenth, 1e-6 * before);
  EXPECT_LT(test_support::kinetic_energy(domain),
            std::max(after_a_tenth, 1e-20 * before)); // no slow growth either
}

TEST(MatchedLayers, AreQuietAfterTwentyThousandSteps) {
  expect_quiet(20000);
}

TEST(AcceptanceMatchedLayers, AreQuietAfterAHundredThousandSteps) {
  expect_quiet(100000);
}

void expect_ground_that_is_held(double end) {
  mpm_domain::Spec spec = test_support::elastic_box(20.0, 10.0, 1.0);
  spec.threads = 1;
  spec.gravity = 9.81;
  spec.matched_sides = {Side::left, Side::right, Side::base};
  mpm_domain::Domain domain(spec);
  mpm_domain::replace_constraints(domain, mpm_domain::relax_under_gravity(domain, {}, [](long, double) {}));
  mpm_domain::Stepper stepper(domain, 0.0, test_support::quiet_ground());
  while (stepper.time() < end)
    stepper.step();
  EXPECT_LT(largest_displacement(domain), 1e-4);
}

TEST(MatchedLayers, HoldTheGroundUnderItsWeightForTwentySeconds) {
  expect_ground_that_is_held(20.0);
}

TEST(AcceptanceMatchedLayers, HoldTheGroundUnderItsWeightForSixtySeconds) {
  expect_ground_that_is_held(60.0);
}

/// A steep slope of 6 m that fails under a strong wave, its toe 4 m above the base: kinetic energy 20 s after
/// the start, J/m, and the largest velocity of any particle until then.
struct Failed {
  double kinetic = 0.0;
  double fastest = 0.0;
  double plastic = 0.0; ///< work, J/m
};

Failed fail(bool layers) {
  const double degree = std::numbers::pi / 180.0;
  mpm_domain::Spec spec;
  spec.box = {0.0, -4.0, 30.0, 6.0};
  spec.cell_size = 1.0;
  spec.gravity = 9.81;
  if (layers)
    spec.matched_sides = {Side::left, Side::right, Side::base};
  spec.soils = {{"sand", materials::MohrCoulomb{.elastic = {1700.0, 40e6, 0.28},
                                                .cohesion_peak = 5e3,
                                                .friction_peak = 30.0 * degree,
                                                .friction_residual = 28.0 * degree,
                                                .softening = 15.0}}};
  spec.regions = {{0, {{0.0, -4.0}, {30.0, -4.0}, {30.0, 6.0}, {17.0, 6.0}, {13.0, 0.0}, {0.0, 0.0}}}};
  mpm_domain::Domain domain(spec);
  mpm_domain::replace_constraints(domain, mpm_domain::relax_under_gravity(domain, {}, [](long, double) {}));
  test_support::PlaneWave wave;
  wave.amplitude = 0.5;
  wave.y_reference = -4.0;
  mpm_domain::Stepper stepper(domain, 0.0, test_support::plane_wave_source(domain, wave, false));
  Failed failed;
  while (stepper.time() < 20.0) {
    stepper.step();
    for (const mpm_domain::Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        failed.fastest = std::max(failed.fastest, std::hypot(set.vx[k], set.vy[k]));
  }
  failed.kinetic = domain.energy.kinetic;
  failed.plastic = domain.energy.plastic;
  return failed;
}

/// Measured: 1.6 J/m.
TEST(MatchedLayers, BringSoilThatHasYieldedToRest) {
  const Failed layers = fail(true);
  EXPECT_GT(layers.plastic, 1e5); // it has yielded
  EXPECT_LT(layers.fastest, 2.0); // 0.5 m/s enter, 1 m/s at the surface, and a slide of some metres
  EXPECT_LT(layers.kinetic, 10.0);
}

/// Before dashpots, which hold no static force, the soil has begun to slide away: 130 J/m.
TEST(AcceptanceMatchedLayers, BringSoilToRestThatSlidesAwayBeforeDashpots) {
  EXPECT_GT(fail(false).kinetic, 5.0 * fail(true).kinetic);
}

} // namespace
} // namespace tremolo
