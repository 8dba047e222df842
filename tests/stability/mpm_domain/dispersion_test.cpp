// With reduced dispersion a free block with noise loses energy only up to the critical step, as without it:
// in place and beside it, drifting through the grid, of soil that is compressible or nearly not. Under
// gravity it comes to rest and stays.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/particle_energy.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <random>

namespace tremolo::mpm_domain {
namespace {

Spec block(double poisson) {
  Spec spec = test_support::elastic_box(4.0, 4.0, 0.5);
  spec.soils.front().law = materials::LinearElastic{{1700.0, 40e6, poisson}};
  spec.threads = 1;
  spec.scheme.fraction = 1.0;
  spec.scheme.dispersion = Dispersion::reduced;
  return spec;
}

/// The largest energy of a block with random velocities of 1 mm/s that drifts, over that at the start; the
/// energy of the drift is not counted.
double growth(const Spec& spec, double shift, Vector drift, long steps) {
  Domain domain(spec);
  std::mt19937 random(1);
  std::normal_distribution<double> speed(0.0, 1e-3);
  double mass = 0.0;
  for (Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.x[k] += shift;
      p.y[k] += 0.7 * shift;
      p.vx[k] = speed(random) + drift.x;
      p.vy[k] = speed(random) + drift.y;
      mass += p.mass[k];
    }
  sort_particles(domain);
  const auto energy = [&] {
    Vector momentum;
    for (const Particles& p : domain.sets)
      for (std::size_t k = 0; k < p.size(); ++k)
        momentum = {momentum.x + p.mass[k] * p.vx[k], momentum.y + p.mass[k] * p.vy[k]};
    return test_support::particle_energy(domain) - 0.5 * square(momentum) / mass;
  };
  const double start = energy();
  double largest = 0.0;
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  while (stepper.steps() < steps) {
    stepper.step();
    if (stepper.steps() % 16 == 0)
      largest = std::max(largest, energy() / start);
  }
  return largest;
}

/// @param shifts  m
void expect_lost_energy(std::initializer_list<double> ratios, std::initializer_list<double> shifts) {
  for (const double poisson : ratios)
    for (const double shift : shifts)
      EXPECT_LT(growth(block(poisson), shift, {}, 20000), 1.0) << poisson << " " << shift;
}

TEST(ReducedDispersion, AFreeBlockWithNoiseLosesEnergyUpToTheCriticalStep) {
  expect_lost_energy({0.28, 0.45}, {0.0, 0.19});
}

TEST(AcceptanceReducedDispersion, AFreeBlockWithNoiseLosesEnergyUpToTheCriticalStep) {
  expect_lost_energy({0.0, 0.28, 0.45}, {0.0, 1e-3, 0.06, 0.19, 0.31});
}

TEST(ReducedDispersion, SoDoesABlockThatDriftsThroughTheGrid) {
  for (const double poisson : {0.0, 0.28, 0.45, 0.49})
    EXPECT_LT(growth(block(poisson), 0.1, {0.05 * 150.0, 0.03 * 150.0}, 2500), 1.0) << poisson;
}

TEST(ReducedDispersion, GroundUnderGravityStaysAtRest) {
  Spec spec = test_support::elastic_box(8.0, 6.0, 0.5);
  spec.gravity = 9.81;
  spec.regions.front().polygon = {{0.0, -6.0}, {8.0, -6.0}, {8.0, -0.0},
                                  {5.0, 0.0},  {3.0, -2.0}, {0.0, -2.0}};
  spec.scheme.dispersion = Dispersion::reduced;
  Domain domain(spec);
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  double fastest = 0.0;
  for (int step = 0; step < 1000; ++step) {
    stepper.step();
    for (const Particles& p : domain.sets)
      for (std::size_t k = 0; k < p.size(); ++k)
        fastest = std::max(fastest, std::hypot(p.vx[k], p.vy[k]));
  }
  EXPECT_LT(fastest, 1e-9);
}

} // namespace
} // namespace tremolo::mpm_domain
