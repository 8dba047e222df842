// Loads on the surface: what the ground does under them in the stage in which they come and afterwards, held
// against closed forms, and that they go with the soil.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/conservation_monitor.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/saved_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::mpm_domain {
namespace {

constexpr double pressure = 50e3; // Pa
constexpr double density = 1800.0;
constexpr double gravity = 9.81;

Spec box(double width, double depth, double h, SurfaceLoad load) {
  Spec spec = test_support::elastic_box(width, depth, h);
  spec.soils.front().law = materials::LinearElastic{{density, 20e6 / 1.2, 0.25}}; // M = 20 MPa
  spec.gravity = gravity;
  spec.loads = {load};
  return spec;
}

Reactions rest(Domain& domain, double residual) {
  const StaticStage load = LoadSettings{{.ramp = 1.0, .residual = residual, .max_time = 20.0}, 0};
  return bring_to_rest(domain, {.residual = residual}, {&load, 1}, [](std::size_t, long, double) {});
}

/// u_y = -q (y + H)/M, sigma_yy = gamma y - q
void expect_uniform_compression(const Spec& spec) {
  Domain domain(spec);
  rest(domain, 1e-8);
  const Particles& p = domain.sets.front();
  const double top = spec.box.y_max;
  double lowest = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double settled = -pressure / 20e6 * (p.y[k] - spec.box.y_min);
    EXPECT_NEAR(p.y[k] - p.y_initial[k], settled, 1e-6);
    EXPECT_NEAR(p.x[k] - p.x_initial[k], 0.0, 1e-9);
    EXPECT_NEAR(p.syy[k], density * gravity * (p.y[k] - top) - pressure, 2e-4 * pressure);
    EXPECT_EQ(p.vx[k], 0.0);
    EXPECT_EQ(p.vy[k], 0.0);
    lowest = std::min(lowest, p.y[k] - p.y_initial[k]);
  }
  EXPECT_NEAR(lowest * 10.0 / 9.875, -25.0e-3, 0.002 * 25.0e-3); // of the surface
}

TEST(SurfaceLoads, CompressLevelGroundUniformly) {
  Spec spec = box(2.0, 10.0, 0.5, {0.0, 2.0, pressure, 0.0});
  spec.sides = Sides::periodic;
  expect_uniform_compression(spec);
  test_support::put_into_container(spec);
  expect_uniform_compression(spec);
}

// sigma_v/q = (a + sin a)/pi, a = 2 atan(B/2z), under the centre of a strip on a half-space
TEST(SurfaceLoads, SpreadUnderAStripAsInAHalfSpace) {
  const double width = 8.0; // B
  Domain domain(box(80.0, 40.0, 1.0, {36.0, 44.0, pressure, 0.0}));
  rest(domain, 1e-5);
  const Particles& p = domain.sets.front();
  for (const double z : {2.0, 4.0, 8.0}) {
    double share = 0.0;
    for (std::size_t k = 0; k < p.size(); ++k)
      if (std::abs(p.x[k] - 40.0) < 0.3 && std::abs(domain.spec.box.y_max - p.y[k] - z) < 0.3)
        share -= 0.25 * (p.syy[k] - density * gravity * (p.y[k] - domain.spec.box.y_max)) / pressure;
    const double a = 2.0 * std::atan(width / (2.0 * z));
    const double exact = (a + std::sin(a)) / std::numbers::pi;
    RecordProperty("z = " + std::to_string(z), std::to_string(share) + " for " + std::to_string(exact));
    EXPECT_NEAR(share, exact, 0.04 * exact) << "z = " << z;
  }
}

/// Ground with an inclined load, ready to step.
struct Loaded {
  Domain domain;
  test_support::PlaneWave wave{.angle = 0.2, .arrival = 0.1, .amplitude = 0.3, .y_reference = -6.0};
  test_support::SavedState faces;
  Stepper stepper;

  static Spec spec() { return box(16.0, 6.0, 1.0, {5.3, 9.1, pressure, 0.2 * pressure}); }

  explicit Loaded(bool shaken, const test_support::SavedState* at_rest = nullptr)
      : domain(spec()), faces(rested(domain, at_rest)),
        stepper(domain, 0.0,
                shaken ? test_support::plane_wave_source(domain, wave, true) : test_support::quiet_ground()) {
  }

  static test_support::SavedState rested(Domain& domain, const test_support::SavedState* at_rest) {
    if (at_rest != nullptr)
      domain.boundary.restore_rest(domain, *at_rest);
    else
      replace_constraints(domain, rest(domain, 1e-9));
    test_support::SavedState saved;
    domain.boundary.save_rest(saved);
    return saved;
  }

  void steps(int count) {
    for (int i = 0; i < count; ++i)
      stepper.step();
  }
};

TEST(SurfaceLoads, LeaveTheGroundAtRest) {
  Loaded ground(false);
  double fastest = 0.0;
  for (int i = 0; i < 200; ++i) {
    ground.stepper.step();
    const Particles& p = ground.domain.sets.front();
    for (std::size_t k = 0; k < p.size(); ++k)
      fastest = std::max(fastest, std::hypot(p.vx[k], p.vy[k]));
  }
  EXPECT_LT(fastest, 1e-7);
}

// The bounds of all hard cases (tests/support/conservation_monitor.hpp).
TEST(SurfaceLoads, KeepTheLedgerClosedInAWave) {
  Loaded ground(true);
  test_support::ConservationMonitor monitor(ground.domain, {.speed = 3.0});
  while (ground.stepper.time() < 1.0) {
    ground.stepper.step();
    monitor.after(ground.stepper);
  }
  monitor.finish();
}

TEST(SurfaceLoads, GoOnFromACheckpointWithTheSameBits) {
  Loaded whole(true);
  whole.steps(37);
  const auto saved = test_support::saved_state(whole.domain, whole.stepper);
  whole.steps(40);
  Loaded resumed(true, &whole.faces);
  test_support::restore_state(saved, resumed.domain, resumed.stepper);
  resumed.steps(40);
  expect_same(test_support::saved_state(whole.domain, whole.stepper),
              test_support::saved_state(resumed.domain, resumed.stepper));
}

TEST(SurfaceLoads, FollowTheNormalAndTheLengthOfTheSurface) {
  Domain domain(Loaded::spec());
  Particles& p = domain.sets.front();
  for (std::size_t k = 0; k < p.size(); ++k) { // stretched by 1 %, inclined by 1:10
    p.y[k] += 0.1 * p.x[k];
    p.x[k] *= 1.01;
  }
  sort_particles(domain);
  domain.loads.follow(domain);
  Vector sum;
  for (const LoadedFace& face : domain.loads.faces())
    sum = {sum.x + face.force.x, sum.y + face.force.y};
  const Vector along{1.01 * 3.8, 0.1 * 3.8};
  EXPECT_NEAR(sum.x, pressure * along.y + 0.2 * pressure * along.x, 1e-6 * pressure);
  EXPECT_NEAR(sum.y, 0.2 * pressure * along.y - pressure * along.x, 1e-6 * pressure);
}

TEST(SurfaceLoads, RefuseWhatCannotCarryThem) {
  Spec spec = Loaded::spec();
  spec.loads.front().x_max = 17.0;
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
  spec.loads.front() = {9.0, 5.0, pressure, 0.0};
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
  spec.loads.front() = {5.0, 9.0, -pressure, 0.0};
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
