// Moments of boxes that follow the soil against F of the whole motion.

#include "mpm_domain/kernel/particle_boxes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace tremolo::mpm_domain {
namespace {

using Gradient = DisplacementGradient<double>;

constexpr double l = 0.25; // m, half side at the start

/// After `steps` equal steps.
BoxMoments<double> after(int steps, const Gradient& du) {
  BoxMoments<double> box{.xx = l * l, .xy = 0.0, .yy = l * l};
  for (int i = 0; i < steps; ++i)
    box = deformed(box, du);
  return box;
}

TEST(ParticleBoxes, FollowAStretchAlongTheAxes) {
  const BoxMoments<double> box = after(50, {.xx = 0.02, .yy = -0.01});
  EXPECT_NEAR(std::sqrt(box.xx), l * std::pow(1.02, 50), 1e-14);
  EXPECT_NEAR(std::sqrt(box.yy), l * std::pow(0.99, 50), 1e-14);
  EXPECT_EQ(box.xy, 0.0);
}

TEST(ParticleBoxes, FollowASimpleShear) {
  const int steps = 64;
  const double strain = 1.5;
  const BoxMoments<double> box = after(steps, {.xy = strain / steps});
  EXPECT_NEAR(box.xx, l * l * (1.0 + strain * strain), 1e-14);
  EXPECT_NEAR(box.xy, l * l * strain, 1e-14);
  EXPECT_NEAR(box.yy, l * l, 1e-15);
}

/// Growth of a box that turns by a quarter as a whole.
double growth_in_a_quarter_turn(int steps) {
  const double turn = 0.5 * std::numbers::pi / steps;
  return std::sqrt(after(steps, {.xy = -turn, .yx = turn}).xx) / l - 1.0;
}

TEST(ParticleBoxes, KeepTheirSizeInARotationToFirstOrder) {
  const double coarse = growth_in_a_quarter_turn(100);
  const double fine = growth_in_a_quarter_turn(200);
  EXPECT_LT(coarse, 0.02);
  EXPECT_NEAR(coarse / fine, 2.0, 0.05);
}

TEST(ParticleBoxes, TurnedRectanglesChangePlaces) {
  const int steps = 20000;
  const double turn = 0.5 * std::numbers::pi / steps;
  BoxMoments<double> box{.xx = l * l, .xy = 0.0, .yy = 4.0 * l * l};
  for (int i = 0; i < steps; ++i)
    box = deformed(box, {.xx = 0.0, .xy = -turn, .yx = turn, .yy = 0.0});
  EXPECT_NEAR(std::sqrt(box.xx), 2.0 * l, 1e-3 * l);
  EXPECT_NEAR(std::sqrt(box.yy), l, 1e-3 * l);
}

TEST(ParticleBoxes, FourAtOnceAreFour) {
  const BoxMoments<double> box{.xx = 0.09, .xy = 0.02, .yy = 0.05};
  const Gradient du{.xx = 0.03, .xy = -0.02, .yx = 0.05, .yy = -0.01};
  const BoxMoments<double> one = deformed(box, du);
  const BoxMoments<Lanes> four = deformed<Lanes>({all(box.xx), all(box.xy), all(box.yy)},
                                                 {all(du.xx), all(du.xy), all(du.yx), all(du.yy)});
  EXPECT_NEAR(four.xx[3], one.xx, 1e-16);
  EXPECT_NEAR(four.xy[1], one.xy, 1e-16);
  EXPECT_NEAR(four.yy[0], one.yy, 1e-16);
}

TEST(ParticleBoxes, StayBetweenTheirLimits) {
  const BoxLimits limits(0.5); // an eighth of a cell to a cell
  const Lanes four = limits.half_side(Lanes{0.0, 0.04, 0.25, 4.0});
  for (const auto& [lane, half] : {std::pair{0, 0.0625}, {1, 0.2}, {2, 0.5}, {3, 0.5}})
    EXPECT_NEAR(four[lane], half, 1e-15);
  EXPECT_EQ(limits.half_side(4.0), 0.5);
  EXPECT_EQ(limits.half_side(0.0), 0.0625);
}

} // namespace
} // namespace tremolo::mpm_domain
