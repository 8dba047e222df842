// The viscous stress of particles, beta D_e : d eps/dt, its work, and what the gravity stage does with it.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/strain/viscous_stress.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr double beta = 4e-3; // s
constexpr double dt = 1e-3;   // s
constexpr double exx = 2e-6, eyy = -1e-6, gxy = 3e-6;

Spec damped_box(const materials::Law& law) {
  Spec spec = test_support::elastic_box(4.0, 6.0, 1.0);
  spec.soils = {{"soil", law, {}, beta}};
  spec.gravity = 9.81;
  return spec;
}

/// Gives all particles of the first set the same increments.
double damp_all(Particles& set) {
  const std::vector<double> xx(set.size(), exx), yy(set.size(), eyy), xy(set.size(), gxy);
  const StrainIncrements increments{xx.data(), yy.data(), xy.data()};
  std::vector<double> ratios(set.size());
  materials::stiffness_ratios(set.law, set.points(0, set.size()), ratios.data());
  return damp(set, {0, set.size()}, increments, increments, ratios.data(), dt);
}

TEST(ViscousStress, IsTheElasticOneOfTheStrainRate) {
  const materials::Elasticity soil{1700.0, 40e6, 0.28};
  Domain domain(damped_box(materials::LinearElastic{soil}));
  Particles& set = domain.sets.front();
  const double sxx = beta / dt * (soil.p_modulus() * exx + soil.lame() * eyy);
  const double syy = beta / dt * (soil.lame() * exx + soil.p_modulus() * eyy);
  const double sxy = beta / dt * soil.shear_modulus() * gxy;
  const double work = 4.0 * 6.0 * (sxx * exx + syy * eyy + sxy * gxy);
  const double first = damp_all(set); // from none: half of it
  EXPECT_NEAR(first, 0.5 * work, 1e-5 * work);
  EXPECT_NEAR(damp_all(set), work, 1e-5 * work);
  for (std::size_t k = 0; k < set.size(); ++k) {
    EXPECT_NEAR(set.viscous_xx[k], sxx, 1e-9 * std::abs(sxx));
    EXPECT_NEAR(set.viscous_yy[k], syy, 1e-9 * std::abs(syy));
    EXPECT_NEAR(set.viscous_xy[k], sxy, 1e-9 * std::abs(sxy));
  }
}

/// G = G_o p_A sqrt(p/p_A) (1 - 0.5 (M_cur/M_b)^4) of each particle, M_b = 2 sin(33 degrees) exp(-0.5 xi_R)
/// in sand denser than critical.
TEST(ViscousStress, FollowsTheStiffnessOfSand) {
  Domain domain(damped_box(
      materials::pm4sand({.density = 1700.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4})));
  relax_under_gravity(domain, {}, [](long, double) {});
  Particles& set = domain.sets.front();
  damp_all(set);
  for (std::size_t k = 0; k < set.size(); ++k) {
    const double p = -0.5 * (set.sxx[k] + set.syy[k]);
    const double ratio = 2.0 * std::hypot(0.5 * (set.sxx[k] - set.syy[k]), set.sxy[k]) / p;
    const double state = 1.5 / (10.0 - std::log(100.0 * p / 101.3e3)) - 0.55;
    const double bounding = 2.0 * std::sin(33.0 * std::numbers::pi / 180.0) * std::exp(-0.5 * state);
    const double shear =
        677.0 * 101.3e3 * std::sqrt(p / 101.3e3) * (1.0 - 0.5 * std::pow(ratio / bounding, 4));
    EXPECT_NEAR(set.viscous_xy[k] / (beta / dt * shear * gxy), 1.0, 1e-9) << set.y[k];
  }
}

/// Sheared to and fro, sand loses stiffness to its fabric and to its stress ratio, beside what it loses to
/// pressure; damping loses it too.
TEST(ViscousStress, IsThatOfTheDegradedStiffness) {
  const materials::Law sand =
      materials::pm4sand({.density = 1700.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4});
  Domain domain(damped_box(sand));
  relax_under_gravity(domain, {}, [](long, double) {});
  Particles& set = domain.sets.front();
  const std::size_t n = set.size();
  std::vector<double> none(n), shear(n), ratios(n), work(n);
  materials::Points points = set.points(0, n);
  points.dexx = points.deyy = points.dwxy = none.data();
  points.dgxy = shear.data();
  points.plastic_work = work.data();
  for (int step = 0; step < 1500; ++step) {
    std::ranges::fill(shear, step / 250 % 2 == 0 ? 2e-5 : -2e-5);
    materials::update(set.law, points);
  }
  damp_all(set);
  materials::stiffness_ratios(set.law, points, ratios.data());
  double least = 1.0; // of what pressure alone leaves
  for (std::size_t k = 0; k < n; ++k) {
    const double shear_modulus = ratios[k] * materials::elasticity(sand).shear_modulus();
    EXPECT_NEAR(set.viscous_xy[k] / (beta / dt * shear_modulus * gxy), 1.0, 1e-12) << set.y[k];
    const double p = -0.5 * (set.sxx[k] + set.syy[k]);
    least = std::min(least, ratios[k] / std::sqrt(p / 101.3e3));
  }
  EXPECT_LT(least, 0.6);
}

TEST(ViscousStress, TakesNoPartInTheGravityStage) {
  const materials::LinearElastic law{{1700.0, 40e6, 0.28}};
  Spec spec = damped_box(law);
  spec.regions = {{0, {{0.0, -6.0}, {4.0, -6.0}, {4.0, 0.0}, {2.0, 0.0}, {0.0, -3.0}}}};
  Domain damped(spec);
  spec.soils.front().damping_time = 0.0;
  Domain undamped(spec);
  for (Domain* domain : {&damped, &undamped})
    relax_under_gravity(*domain, {}, [](long, double) {});
  const Particles& set = damped.sets.front();
  EXPECT_EQ(set.syy, undamped.sets.front().syy);
  EXPECT_EQ(set.sxy, undamped.sets.front().sxy);
  EXPECT_EQ(set.viscous_yy, std::vector<double>(set.size(), 0.0));
  EXPECT_EQ(set.damping_time, beta);
}

TEST(ViscousStress, NeedsADampingTimeOfAtLeastZero) {
  Spec spec = damped_box(materials::LinearElastic{{1700.0, 40e6, 0.28}});
  spec.soils.front().damping_time = -1e-3;
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
