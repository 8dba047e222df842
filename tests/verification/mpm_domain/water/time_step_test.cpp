// Permeability does not limit the step: a saturated block with free corners, full of noise, stays bounded
// close to the limit that the domain tells, from 1 to 1e-9 m/s. Without damping the energy of the transfer
// FLIP would grow at once if a mode did.

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

namespace tremolo::mpm_domain {
namespace {

using Scheme = std::tuple<Transfer, StepOrder, double>;

class SaturatedStep : public testing::TestWithParam<Scheme> {};

/// Kinetic energy of grains and water, that of the skeleton's strain and of the excess pressure, J/m.
double energy_of(const Domain& domain) {
  double energy = 0.0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const PoreWater& water = *set.water;
      const double n = water.porosity(set.mass[k], set.volume[k]);
      const double p = excess_pressure(set, k);
      const double of_water = n * water.fluid.density * set.volume[k];
      energy += 0.5 * set.mass[k] * (set.vx[k] * set.vx[k] + set.vy[k] * set.vy[k]) +
                0.5 * of_water * (set.wx[k] * set.wx[k] + set.wy[k] * set.wy[k]) +
                set.volume[k] * materials::elasticity(set.law).energy_density(set.sxx[k], set.syy[k],
                                                                              set.szz[k], set.sxy[k]) +
                0.5 * set.volume[k] * n / water.fluid.bulk_modulus * p * p;
    }
  return energy;
}

TEST_P(SaturatedStep, IsStableAtAnyPermeability) {
  const auto [transfer, order, fraction] = GetParam();
  for (const double permeability : {1.0, 1e-2, 1e-3, 1e-4, 1e-5, 1e-7, 1e-9}) {
    SCOPED_TRACE(permeability);
    Spec spec;
    spec.box = {0.0, -4.0, 8.0, 0.0};
    spec.cell_size = 0.5;
    spec.gravity = 1e-6; // with the permeability scaled alike: drag as it is, and no weight
    spec.scheme.transfer = transfer;
    spec.scheme.order = order;
    spec.scheme.fraction = fraction;
    spec.water = {0.0, {}};
    Soil soil{.name = "soil", .law = materials::LinearElastic{{1990.0, 8e7, 0.3}}};
    soil.pores = {
        .porosity = 0.4, .grain_density = 2650.0, .permeability = permeability * spec.gravity / 9.81};
    spec.soils = {soil};
    spec.regions = {{0, {{2.0, -4.0}, {6.0, -4.0}, {6.0, 0.0}, {2.0, 0.0}}}};
    Domain domain(spec);
    std::mt19937 random(5);
    std::normal_distribution<double> speed(0.0, 1e-4); // m/s
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        for (std::vector<double>* v : {&set.vx, &set.vy, &set.wx, &set.wy})
          (*v)[k] = speed(random);
    Stepper stepper(domain, 0.0, test_support::quiet_ground());
    // The largest energy within each of three spans: none may exceed the one before.
    const double given = energy_of(domain);
    double before = given;
    for (int span = 0; span < 3; ++span) {
      double largest = 0.0;
      for (int step = 0; step < 500; ++step) {
        stepper.step();
        if (step % 10 == 9)
          largest = std::max(largest, energy_of(domain));
      }
      EXPECT_LT(largest, before);
      before = largest;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, SaturatedStep,
                         testing::Values(Scheme{Transfer::apic, StepOrder::musl, 0.95},
                                         Scheme{Transfer::flip, StepOrder::musl, 0.95},
                                         Scheme{Transfer::apic, StepOrder::usl, 0.95 * 0.85},
                                         Scheme{Transfer::flip, StepOrder::usl, 0.95 * 0.85}));

} // namespace
} // namespace tremolo::mpm_domain
