// The stress of relaxation mechanisms of particles, against their equations for one component, under
// rotation, in wet soil, and in the gravity stage.

#include "mpm_domain/strain/relaxation_stress.hpp"

#include "materials/relaxation/constant_damping.hpp"
#include "materials/tensor/objective_rate.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/spec/bytes.hpp"
#include "mpm_domain/strain/strain_update.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr double dt = 1e-3; // s
const materials::Elasticity soil{1700.0, 40e6, 0.28};
const materials::Relaxation damping = materials::relaxation({3.0, {}}, 0.05);

Spec damped_box(const materials::Relaxation& relaxation = damping) {
  Spec spec = test_support::elastic_box(4.0, 6.0, 1.0);
  spec.soils = {{.name = "soil", .law = materials::LinearElastic{soil}, .relaxation = relaxation}};
  return spec;
}

/// Strains the first particles of a set alike.
/// @returns the work of the mechanisms
double strain(Particles& set, double exx, double eyy, double gxy, double wxy) {
  Increments increments;
  increments.exx.fill(exx);
  increments.eyy.fill(eyy);
  increments.gxy.fill(gxy);
  increments.wxy.fill(wxy);
  increments.plastic.fill(0.0);
  LaneSums sums;
  const Increments moved = increments;
  strain_chunk(set, 0, std::min(set.size(), strain_chunk_size), increments, moved, dt, sums);
  return sums.viscous;
}

/// q of one component, of which the law's stress rises by so much each step.
double borne(double law_increment, int steps) {
  double sum = 0.0;
  for (std::size_t j = 0; j < damping.time.size(); ++j) {
    const auto [kept, taken] = materials::relaxation_step(damping, j, dt);
    double q = 0.0;
    for (int n = 0; n < steps; ++n)
      q = kept * q + taken * law_increment;
    sum += q;
  }
  return sum;
}

TEST(RelaxationStress, FollowsTheLawsIncrements) {
  constexpr double exx = 2e-6, eyy = -1e-6, gxy = 3e-6;
  Domain domain(damped_box());
  Particles& set = domain.sets.front();
  constexpr int steps = 20;
  double work = 0.0;
  for (int n = 0; n < steps; ++n)
    work += strain(set, exx, eyy, gxy, 0.0);
  const double c = damping.relaxed;
  const double xx = c * (soil.p_modulus() * exx + soil.lame() * eyy);
  const double yy = c * (soil.lame() * exx + soil.p_modulus() * eyy);
  const double xy = c * soil.shear_modulus() * gxy;
  for (const std::size_t k : {std::size_t{0}, std::size_t{5}}) {
    EXPECT_NEAR(set.sxx[k], steps * xx, 1e-9 * std::abs(steps * xx));
    EXPECT_NEAR(set.viscous_xx[k], borne(xx, steps), 1e-9 * std::abs(xx));
    EXPECT_NEAR(set.viscous_yy[k], borne(yy, steps), 1e-9 * std::abs(xx));
    EXPECT_NEAR(set.viscous_xy[k], borne(xy, steps), 1e-9 * std::abs(xx));
  }
  double expected = 0.0; // per volume
  for (int n = 0; n < steps; ++n)
    expected += 0.5 * ((borne(xx, n) + borne(xx, n + 1)) * exx + (borne(yy, n) + borne(yy, n + 1)) * eyy +
                       (borne(xy, n) + borne(xy, n + 1)) * gxy);
  EXPECT_NEAR(work / (24.0 * expected), 1.0, 1e-4); // the box has 24 m2
}

/// Soil that only turns is not strained, whatever stress it bears.
TEST(RelaxationStress, IsNotMadeByRotation) {
  Domain domain(damped_box());
  Particles& set = domain.sets.front();
  for (std::size_t k = 0; k < set.size(); ++k) {
    set.sxx[k] = -5e4;
    set.syy[k] = -1e5;
    set.sxy[k] = 1e4;
  }
  for (int n = 0; n < 50; ++n)
    strain(set, 0.0, 0.0, 0.0, 0.02);
  EXPECT_GT(std::abs(set.sxy[0]), 1.5e4);
  EXPECT_NEAR(set.viscous_xx[0], 0.0, 1e-6);
  EXPECT_NEAR(set.viscous_yy[0], 0.0, 1e-6);
  EXPECT_NEAR(set.viscous_xy[0], 0.0, 1e-6);
}

TEST(RelaxationStress, TurnsWithTheSoil) {
  Domain domain(damped_box());
  Particles& set = domain.sets.front();
  strain(set, 0.0, 0.0, 1e-5, 0.0);
  const double fresh = set.viscous_xy[0];
  strain(set, 0.0, 0.0, 0.0, 0.3);
  double kept = 0.0;
  const double xy = damping.relaxed * soil.shear_modulus() * 1e-5;
  for (std::size_t j = 0; j < damping.time.size(); ++j) {
    const auto step = materials::relaxation_step(damping, j, dt);
    kept += step.kept * step.taken * xy;
  }
  const auto turned = materials::rotated({0.0, 0.0, kept}, 0.3);
  EXPECT_GT(fresh, kept);
  EXPECT_NEAR(set.viscous_xx[0], turned.xx, 1e-9 * fresh);
  EXPECT_NEAR(set.viscous_yy[0], turned.yy, 1e-9 * fresh);
  EXPECT_NEAR(set.viscous_xy[0], turned.xy, 1e-9 * fresh);
}

TEST(RelaxationStress, OfWetSoilIsADeviatorAndLeavesTheStiffnessAgainstVolume) {
  Spec spec = damped_box();
  spec.gravity = 9.81;
  spec.water = {0.0, {}};
  spec.soils.front().pores = {
      .porosity = 0.4, .grain_density = 1300.0 / 0.6, .drainage = materials::Drainage::undrained};
  Domain domain(spec);
  Particles& set = *std::ranges::find_if(domain.sets, [](const Particles& one) { return one.size() > 0; });
  ASSERT_TRUE(set.traits.wet);
  const double at_rest = set.sxx[0];
  strain(set, 1e-6, 1e-6, 0.0, 0.0);
  const double expected = 2e-6 * (soil.lame() + soil.shear_modulus());
  EXPECT_NEAR(set.sxx[0] - at_rest, expected, 1e-8 * expected);
  EXPECT_NEAR(set.viscous_xx[0], 0.0, 1e-9 * expected);
  strain(set, 2e-6, 0.0, 0.0, 0.0);
  EXPECT_GT(set.viscous_xx[0], 0.0);
  EXPECT_EQ(set.viscous_yy[0], -set.viscous_xx[0]);
}

TEST(RelaxationStress, TakesNoPartInTheGravityStage) {
  Spec spec = damped_box();
  spec.gravity = 9.81;
  spec.regions = {{0, {{0.0, -6.0}, {4.0, -6.0}, {4.0, 0.0}, {2.0, 0.0}, {0.0, -3.0}}}};
  Domain damped(spec);
  spec.soils.front().relaxation = {};
  Domain undamped(spec);
  for (Domain* domain : {&damped, &undamped})
    relax_under_gravity(*domain, {}, [](long, double) {});
  const Particles& set = damped.sets.front();
  EXPECT_EQ(set.syy, undamped.sets.front().syy);
  EXPECT_EQ(set.sxy, undamped.sets.front().sxy);
  EXPECT_EQ(set.viscous_yy, std::vector<double>(set.size(), 0.0));
  EXPECT_EQ(set.relaxation.time, damping.time);
}

TEST(RelaxationStress, IsForgottenAsAWhole) {
  Domain domain(damped_box());
  Particles& set = domain.sets.front();
  strain(set, 1e-6, 2e-6, 3e-6, 0.0);
  forget(set);
  set.for_fields([&](const ParticleFieldDescription& line, const std::vector<double>& values) {
    if (line.trait == FieldTrait::damped) {
      EXPECT_EQ(values, std::vector<double>(set.size(), 0.0)) << line.name;
    }
  });
}

/// Three doubles a mechanism, and their sum.
TEST(RelaxationStress, HasFieldsInTheTable) {
  std::size_t fields = 0;
  Domain domain(damped_box());
  domain.sets.front().for_fields([&](const ParticleFieldDescription& line, const std::vector<double>&) {
    fields += line.trait == FieldTrait::damped ? 1 : 0;
  });
  EXPECT_EQ(fields, 3 * damping.time.size() + 3);
  Domain bare(damped_box({}));
  bare.sets.front().for_fields([](const ParticleFieldDescription& line, const std::vector<double>&) {
    EXPECT_NE(line.trait, FieldTrait::damped);
  });
}

} // namespace
} // namespace tremolo::mpm_domain
