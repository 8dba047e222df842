// Springs beside the dashpots: level ground passes them unnoticed, and they hold a load that comes to bear
// after the model was at rest.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace tremolo {
namespace {

using test_support::add_springs;

/// Velocities of all particles every 10 steps while an oblique wave shakes level ground.
std::vector<Vector> shaken(const mpm_domain::Spec& spec) {
  mpm_domain::Domain domain(spec);
  test_support::PlaneWave wave{.amplitude = 0.12, .y_reference = -20.0};
  wave.angle = 15.0 * std::numbers::pi / 180.0;
  mpm_domain::Stepper stepper(domain, 0.0, test_support::plane_wave_source(domain, wave, true));
  std::vector<Vector> velocities;
  while (stepper.time() < 3.0) {
    stepper.step();
    if (stepper.steps() % 10 != 0)
      continue;
    for (const mpm_domain::Particles& set : domain.sets)
      for (std::uint32_t id = 0; id < set.size(); ++id) {
        const std::size_t k = set.index_of[id];
        velocities.push_back({set.vx[k], set.vy[k]});
      }
  }
  return velocities;
}

// The peak is that of the surface, some 0.24 m/s. A blended base on level ground has the same field as a
// total one.
TEST(GroundSprings, PassTheMotionOfLevelGround) {
  const mpm_domain::Spec without = test_support::elastic_box(40.0, 20.0, 1.0);
  const std::vector<Vector> plain = shaken(without);
  double peak = 0.0;
  for (const Vector& v : plain)
    peak = std::max(peak, std::hypot(v.x, v.y));
  EXPECT_NEAR(peak, 0.24, 0.03);
  for (const auto& [across, along, lags] : {std::tuple{2.0, 1.0, false}, std::tuple{0.5, 0.25, true}}) {
    mpm_domain::Spec spec = without;
    add_springs(spec, across, along, {20.0, 0.0}, lags);
    const std::vector<Vector> held = shaken(spec);
    ASSERT_EQ(held.size(), plain.size());
    double difference = 0.0;
    for (std::size_t i = 0; i < held.size(); ++i)
      difference = std::max(difference, std::hypot(held[i].x - plain[i].x, held[i].y - plain[i].y));
    RecordProperty("a = " + std::to_string(across), std::to_string(difference / peak));
    EXPECT_LT(difference, 2e-3 * peak) << "a = " << across;
  }
}

// Soil of 150 m/s, 80 by 20 m, a = 1 and 0.5 around the middle of the surface, 100 kPa on 6 m of it: 15.9 mm
// by finite elements of 1 m with the same springs. Above rigid ground at 200 m depth it would be 15.3 mm. In
// dry ground the implicit half of the dashpots carries what kicks of the nodes leave (boundary.hpp): 1 % of
// the load, which the springs carry besides.
TEST(GroundSprings, HoldALoadOnTheSurface) {
  const double shear = 1800.0 * 150.0 * 150.0;
  mpm_domain::Spec spec = test_support::elastic_box(80.0, 20.0, 1.0);
  spec.soils = {{"soil", materials::LinearElastic{{1800.0, 2.6 * shear, 0.3}}}};
  spec.gravity = 9.81;
  add_springs(spec, 1.0, 0.5, {40.0, 0.0});
  mpm_domain::Domain domain(spec);
  mpm_domain::replace_constraints(domain, mpm_domain::relax_under_gravity(domain, {}, [](long, double) {}));
  mpm_domain::Particles& set = domain.sets.front();
  const double each = 100e3 * 6.0 / 12.0 / spec.gravity; // kg/m for each of the 12 topmost particles
  std::vector<std::uint32_t> loaded;
  for (std::size_t k = 0; k < set.size(); ++k)
    if (set.y[k] > -0.5 && std::abs(set.x[k] - 40.0) < 3.0) {
      set.mass[k] += each;
      loaded.push_back(set.id[k]);
    }
  ASSERT_EQ(loaded.size(), 12U);
  std::vector<double> before;
  for (const std::uint32_t id : loaded)
    before.push_back(set.y[set.index_of[id]]);
  mpm_domain::Stepper stepper(domain, 0.0, test_support::quiet_ground());
  while (stepper.time() < 4.0)
    stepper.step();
  double settlement = 0.0; // of the two in the middle
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    const std::size_t k = set.index_of[loaded[i]];
    if (std::abs(set.x[k] - 40.0) < 0.5)
      settlement += 0.5 * (before[i] - set.y[k]);
  }
  double carried = 0.0;
  const auto faces = domain.boundary.faces();
  for (std::size_t f = 0; f < faces.size(); ++f)
    carried += faces[f].length * domain.boundary.supports().loads()[f].spring.y;
  RecordProperty("settlement_mm", std::to_string(1e3 * settlement));
  RecordProperty("carried_kN_per_m", std::to_string(1e-3 * carried));
  EXPECT_NEAR(settlement, 15.9e-3, 0.03 * 15.9e-3);
  EXPECT_NEAR(carried, 600e3, 0.015 * 600e3);
}

} // namespace
} // namespace tremolo
