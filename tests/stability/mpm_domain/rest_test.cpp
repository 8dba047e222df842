// Rest under self weight: when the supports of the gravity stage are replaced by tractions, nothing may move.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo {
namespace {

/// Largest particle speed in 1 s after the switch with no motion applied, m/s.
double speed_after_switch(mpm_domain::Domain& domain) {
  const mpm_domain::Reactions reactions = mpm_domain::relax_under_gravity(domain, {}, [](long, double) {});
  mpm_domain::replace_constraints(domain, reactions);
  mpm_domain::Stepper stepper(domain, 0.0, test_support::quiet_ground());
  double fastest = 0.0;
  while (stepper.time() < 1.0) {
    stepper.step();
    for (const mpm_domain::Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        fastest = std::max(fastest, std::hypot(set.vx[k], set.vy[k]));
  }
  return fastest;
}

TEST(RestAfterSwitch, ElasticBox) {
  mpm_domain::Spec spec = test_support::elastic_box(100.0, 40.0, 1.0);
  spec.gravity = 9.81;
  mpm_domain::Domain domain(spec);
  EXPECT_LT(speed_after_switch(domain), 1e-6);
}

// Two soils side by side are not at rest under their overburden: the stage has to find the equilibrium.
TEST(RestAfterSwitch, StiffSoilBesideSoftSoil) {
  mpm_domain::Spec spec = test_support::elastic_box(40.0, 20.0, 1.0);
  spec.gravity = 9.81;
  spec.soils.push_back({"stiff", materials::LinearElastic{{2000.0, 160e6, 0.2}}});
  spec.regions.push_back({1, {{20.0, -20.0}, {40.0, -20.0}, {40.0, 0.0}, {25.0, 0.0}}});
  mpm_domain::Domain domain(spec);
  EXPECT_LT(speed_after_switch(domain), 1e-6);
}

TEST(RestAfterSwitch, StrainSofteningSlope) {
  const double degree = std::numbers::pi / 180.0;
  mpm_domain::Spec spec;
  spec.box = {0.0, -20.0, 90.0, 10.0};
  spec.cell_size = 1.0;
  spec.gravity = 9.81;
  spec.threads = 2;
  spec.soils = {{"sand", materials::MohrCoulomb{.elastic = {1700.0, 40e6, 0.28},
                                                .cohesion_peak = 4e3,
                                                .friction_peak = 45.0 * degree,
                                                .friction_residual = 28.0 * degree,
                                                .softening = 15.0}}};
  spec.regions = {{0, {{0.0, -20.0}, {90.0, -20.0}, {90.0, 10.0}, {50.0, 10.0}, {40.0, 0.0}, {0.0, 0.0}}}};
  mpm_domain::Domain domain(spec);
  EXPECT_LT(speed_after_switch(domain), 1e-5);
}

/// Sands whose stiffness grows with pressure, dry.
mpm_domain::Spec box_of(const materials::Law& sand) {
  mpm_domain::Spec spec = test_support::elastic_box(20.0, 10.0, 1.0);
  spec.gravity = 9.81;
  spec.soils = {{"sand", sand}};
  return spec;
}

materials::Law pm4sand_55() {
  return materials::pm4sand({.density = 1700.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4});
}

TEST(RestAfterSwitch, Pm4Sand) {
  mpm_domain::Domain domain(box_of(pm4sand_55()));
  EXPECT_LT(speed_after_switch(domain), 1e-5);
}

TEST(RestAfterSwitch, Pdmy03) {
  mpm_domain::Domain domain(box_of(materials::pdmy03(materials::pdmy03_recommended(0.57))));
  EXPECT_LT(speed_after_switch(domain), 1e-5);
}

/// A face of 60 degrees in sand of a friction angle of 25: gravity asks more of the cone than it has.
TEST(GravityStage, NamesSoilAndPlaceWhereTheLawCannotHoldTheStress) {
  mpm_domain::Spec spec = box_of(materials::pdmy03(materials::pdmy03_recommended(0.33)));
  mpm_domain::Domain level(spec);
  EXPECT_TRUE(mpm_domain::relax_under_gravity(level, {}, [](long, double) {}).cut.empty());
  spec.regions = {{0, {{0.0, -10.0}, {20.0, -10.0}, {20.0, 0.0}, {12.0, 0.0}, {8.0, -7.0}, {0.0, -7.0}}}};
  mpm_domain::Domain steep(spec);
  const auto cut = mpm_domain::relax_under_gravity(steep, {}, [](long, double) {}).cut;
  ASSERT_EQ(cut.size(), 1U);
  EXPECT_EQ(cut[0].soil, "sand");
  EXPECT_GT(cut[0].particles, 0U);
  EXPECT_LT(cut[0].particles, steep.particle_count() / 2);
  // The face, which runs from (8, -7) to (12, 0), is among it, and nothing lies outside the ground.
  EXPECT_LT(cut[0].low.x, 9.0);
  EXPECT_GT(cut[0].high.x, 9.0);
  EXPECT_GE(cut[0].low.x, 0.0);
  EXPECT_GE(cut[0].low.y, -10.0);
  EXPECT_LE(cut[0].high.y, 0.0);
}

/// G = G_o p_A sqrt(p/p_A) in the deepest particles' stress, elastic K_0 = nu/(1 - nu): what limits the time
/// step and what the base's dashpots match, sqrt((K + 4G/3)/rho) with (K + 4G/3)/G = 2 (1 - nu)/(1 - 2 nu).
TEST(StiffnessOfPressure, SetsTimeStepAndDashpots) {
  mpm_domain::Domain domain(box_of(pm4sand_55()));
  mpm_domain::relax_under_gravity(domain, {}, [](long, double) {});
  const double nu = 0.3;
  const double vertical = 1700.0 * 9.81 * 9.75; // of the lowest particles, Pa
  const double p = 0.5 * (1.0 + nu / (1.0 - nu)) * vertical;
  const double shear = 677.0 * 101.3e3 * std::sqrt(p / 101.3e3);
  const double c_p = std::sqrt(2.0 * (1.0 - nu) / (1.0 - 2.0 * nu) * shear / 1700.0);
  EXPECT_NEAR(domain.fastest_wave(), c_p, 1e-4 * c_p);
  EXPECT_NEAR(mpm_domain::critical_time_step(domain, 0.0), 0.65 / c_p, 1e-4 / c_p);
  double base = 0.0;
  for (const mpm_domain::BoundaryFace& face : domain.boundary.faces())
    if (face.side == mpm_domain::Side::base)
      base = std::max(base, face.ground.impedance_p);
  EXPECT_NEAR(base, 1700.0 * c_p, 1e-4 * 1700.0 * c_p);
}

} // namespace
} // namespace tremolo
