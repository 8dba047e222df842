// A saturated block that nothing holds and that has no weight, under noise of grains and water. Particles
// ride on the grains, and the mass of their water follows their pores, m_f = rho_f (V - c m_s). So the
// momentum of both is not constant: a step changes it by what its new masses of water carry, sum dm_f v_f,
// and by nothing else.

#include "mpm_domain/particles/water/pore_volume.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>

namespace tremolo::mpm_domain {
namespace {

Spec block(Transfer transfer, StepOrder order) {
  Spec spec = test_support::elastic_box(4.0, 3.0, 0.5);
  spec.gravity = 9.81;
  spec.water = {0.0, {}};
  spec.soils.front().pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-3};
  spec.scheme.transfer = transfer;
  spec.scheme.order = order;
  spec.scheme.dt = 5e-5; // s
  return spec;
}

double water_mass(const Particles& set, std::size_t k) {
  return set.water->fluid.density * pore_volume(set, k);
}

/// Momentum of the wet particles.
struct Momentum {
  Vector soil, water;
  std::vector<double> masses; ///< of water
};

Momentum momentum_of(const Domain& domain) {
  Momentum p;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double m = water_mass(set, k);
      p.soil = {p.soil.x + set.mass[k] * set.vx[k], p.soil.y + set.mass[k] * set.vy[k]};
      p.water = {p.water.x + m * set.wx[k], p.water.y + m * set.wy[k]};
      p.masses.push_back(m);
    }
  return p;
}

class FreeBlock : public testing::TestWithParam<std::tuple<Transfer, StepOrder>> {};

TEST_P(FreeBlock, KeepsTheMomentumOfGrainsAndWater) {
  Domain domain(block(std::get<Transfer>(GetParam()), std::get<StepOrder>(GetParam())));
  domain.boundary.remove_faces();
  std::mt19937 random(5);
  std::normal_distribution<double> speed(0.0, 1e-2); // m/s
  double size = 0.0;
  for (Particles& set : domain.sets) {
    set.weight_share = 0.0;
    for (std::size_t k = 0; k < set.size(); ++k) {
      for (double* v : {&set.vx[k], &set.vy[k], &set.wx[k], &set.wy[k]})
        *v = speed(random);
      size += set.mass[k] * std::abs(set.vx[k]);
    }
  }
  Stepper stepper(domain, 0.0, {});
  double changed = 0.0; // by new masses of water
  for (int step = 0; step < 200; ++step) {
    const Momentum before = momentum_of(domain);
    stepper.step();
    const Momentum after = momentum_of(domain);
    Vector carried;
    std::size_t i = 0;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k, ++i) {
        const double gained = after.masses[i] - before.masses[i];
        carried = {carried.x + gained * set.wx[k], carried.y + gained * set.wy[k]};
      }
    changed += std::abs(carried.x) + std::abs(carried.y);
    ASSERT_NEAR(after.soil.x + after.water.x - before.soil.x - before.water.x, carried.x, 1e-13 * size);
    ASSERT_NEAR(after.soil.y + after.water.y - before.soil.y - before.water.y, carried.y, 1e-13 * size);
  }
  EXPECT_GT(changed, 1e-11 * size);
}

INSTANTIATE_TEST_SUITE_P(Schemes, FreeBlock,
                         testing::Combine(testing::Values(Transfer::apic, Transfer::flip),
                                          testing::Values(StepOrder::musl, StepOrder::usl)),
                         [](const auto& test) {
                           return std::string(tremolo::name(std::get<0>(test.param))) + "_" +
                                  std::string(tremolo::name(std::get<1>(test.param)));
                         });

} // namespace
} // namespace tremolo::mpm_domain
