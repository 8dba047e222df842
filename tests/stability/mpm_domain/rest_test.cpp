// Rest under self weight: when the supports of the gravity stage are replaced by tractions, nothing may move.

#include "mpm_domain/gravity_stage.hpp"
#include "mpm_domain/static_traction.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo {
namespace {

/// Largest particle speed in 1 s after the switch with no motion applied, m/s.
double speed_after_switch(mpm_domain::Domain& domain) {
  const mpm_domain::Reactions reactions = mpm_domain::relax_under_gravity(domain, {}, [](long, double) {});
  mpm_domain::replace_constraints(domain, reactions);
  mpm_domain::Stepper stepper(domain, 0.0, [&](long, double, auto v, auto traction) {
    for (std::size_t f = 0; f < v.size(); ++f)
      traction[f] = eq6::boundary_traction(domain.faces[f].face, v[f], {}, domain.static_tractions[f]);
  });
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
  spec.cell_size = 0.5;
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

} // namespace
} // namespace tremolo
