// A cylinder on an incline: it rolls with a = 2/3 g sin(theta), alpha = a/R where tan(theta) <= 3 mu, and
// slides with a = g (sin(theta) - mu cos(theta)), alpha = 2 mu g cos(theta)/R where it is steeper.

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test_support::circle;
using test_support::flat_ground;
using test_support::StandingScene;
using test_support::structure;

constexpr double gravity = 9.81; // m/s2
constexpr double radius = 1.0;   // R, m

/// Accelerations over those of the closed form.
struct Accelerations {
  double along, turning;
};

/// Over 0.6 s, once the soil has sprung back from the bonds.
Accelerations down_incline(double degrees, double friction, double h) {
  constexpr double half = 3.0, young = 2e7; // of the incline's width, m; Pa
  const double angle = degrees * std::numbers::pi / 180.0;
  const double rise = half * std::tan(angle);
  const double depth = std::ceil((rise + 1.0) / h) * h;
  Spec spec = flat_ground(2.0 * half, depth, h, {2000.0, young, 0.2});
  spec.box.y_max = std::ceil(rise / h) * h + h;
  spec.regions.front().polygon = {{-half, -depth}, {half, -depth}, {half, rise}, {-half, -rise}};
  spec.structures = {structure(
      circle({std::cos(angle) - radius * std::sin(angle), std::sin(angle) + radius * std::cos(angle)}, radius,
             128),
      2000.0, friction)};
  StandingScene scene(spec, test_support::quiet_ground(), 1e-5);
  const auto speed = [&] {
    const Vector v = scene.body().motion().velocity;
    return -(v.x * std::cos(angle) + v.y * std::sin(angle));
  };
  scene.run(0.1);
  const double time = scene.stepper.velocity_time();
  const double along = speed();
  const double spin = scene.body().motion().spin;
  scene.run(0.6);
  const double interval = scene.stepper.velocity_time() - time;
  const bool rolls = std::tan(angle) <= 3.0 * friction;
  const double exact = rolls ? 2.0 / 3.0 * gravity * std::sin(angle)
                             : gravity * (std::sin(angle) - friction * std::cos(angle));
  const double exact_turning = rolls ? exact / radius : 2.0 * friction * gravity * std::cos(angle) / radius;
  return {(speed() - along) / interval / exact,
          (scene.body().motion().spin - spin) / interval / exact_turning};
}

TEST(Cylinder, AcceptanceRollsDownAnIncline) {
  const Accelerations coarse = down_incline(20.0, 1.0, 0.2); // 10 cells across
  const Accelerations fine = down_incline(20.0, 1.0, 0.1);
  EXPECT_NEAR(fine.along, 1.0, 0.12);
  EXPECT_NEAR(fine.turning, 1.0, 0.12);
  EXPECT_LT(std::abs(fine.along - 1.0), 0.6 * std::abs(coarse.along - 1.0));
  EXPECT_LT(std::abs(fine.turning - 1.0), 0.6 * std::abs(coarse.turning - 1.0));
  RecordProperty("10_cells", std::to_string(coarse.along));
  RecordProperty("20_cells", std::to_string(fine.along));
}

TEST(Cylinder, SlidesDownASteepIncline) {
  const Accelerations found = down_incline(45.0, 0.2, 0.1);
  EXPECT_NEAR(found.along, 1.0, 0.05);
  EXPECT_NEAR(found.turning, 1.0, 0.12);
  RecordProperty("along", std::to_string(found.along));
  RecordProperty("turning", std::to_string(found.turning));
}

} // namespace
} // namespace tremolo::mpm_domain
