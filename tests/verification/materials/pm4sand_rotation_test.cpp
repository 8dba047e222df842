// PM4Sand keeps its tensors, and the rule that looks at the horizontal plane, in axes that turn with the
// material: a rigid turn by 90 degrees in the middle of a cyclic test changes nothing.

#include "tests/support/pm4sand_soil.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo::materials::test {
namespace {

/// Cycles of 0.1 per cent about a static shear stress at constant volume, with small reversals within them;
/// turned by 90 degrees after the second cycle.
PointTest cycled(int turning_steps) {
  PointTest point(report_sand(55), geostatic(100.0 * kilopascal, 0.5, 8.0 * kilopascal));
  constexpr int steps_per_cycle = 400;
  constexpr int cycles = 4;
  const auto strain = [](int n) {
    const double phase = 2.0 * std::numbers::pi * n / steps_per_cycle;
    return 1e-3 * (std::sin(phase) + 0.4 * std::sin(7.0 * phase));
  };
  for (int n = 0; n < cycles * steps_per_cycle; ++n) {
    const bool turned = turning_steps > 0 && 2 * n >= cycles * steps_per_cycle;
    for (int k = 0; turned && 2 * n == cycles * steps_per_cycle && k < turning_steps; ++k) {
      PointStep turn;
      turn.rotation = 2.0 * std::tan(0.25 * std::numbers::pi / turning_steps);
      point.apply(turn);
    }
    const double shear = strain(n + 1) - strain(n);
    const double axial = 0.1 * shear; // xx of the material
    point.apply({Control::strain(turned ? -axial : axial), Control::strain(turned ? axial : -axial),
                 Control::strain(turned ? -shear : shear)});
  }
  return point;
}

TEST(Pm4Rotation, AQuarterTurnInTheMiddleChangesNothing) {
  const PointTest still = cycled(0);
  const PointStress& a = still.stress();
  const double bound = 1e-8 * pressure(a);
  for (const int steps : {2, 3, 10, 10000}) {
    const PointTest turned = cycled(steps);
    const PointStress& b = turned.stress();
    EXPECT_NEAR(b.xx, a.yy, bound) << steps;
    EXPECT_NEAR(b.yy, a.xx, bound) << steps;
    EXPECT_NEAR(b.zz, a.zz, bound) << steps;
    EXPECT_NEAR(b.xy, -a.xy, bound) << steps;
    EXPECT_NEAR(turned.plastic_work(), still.plastic_work(), 1e-8 * still.plastic_work()) << steps;
    for (std::size_t k = 1; k < turned.state().size(); ++k) { // all but the angle
      EXPECT_NEAR(turned.state()[k], still.state()[k], 1e-8 * (1.0 + std::abs(still.state()[k]))) << k;
    }
  }
}

/// While it turns steadily: the same strain in the axes of the material, a rotation with every increment.
TEST(Pm4Rotation, SteadyTurningChangesNothing) {
  const PointStress initial = geostatic(100.0 * kilopascal, 0.5);
  PointTest still(report_sand(55), initial);
  PointTest turning(report_sand(55), initial);
  double angle = 0.0;
  constexpr double w = 5e-3;
  for (int n = 0; n < 2000; ++n) {
    const double shear = 5e-4 * (std::sin(0.02 * (n + 1)) - std::sin(0.02 * n));
    still.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(shear)});
    angle += 2.0 * std::atan(0.5 * w);
    const double s2 = std::sin(2.0 * angle);
    PointStep step = {Control::strain(-0.5 * shear * s2), Control::strain(0.5 * shear * s2),
                      Control::strain(shear * std::cos(2.0 * angle))};
    step.rotation = w;
    turning.apply(step);
  }
  const double p = pressure(still.stress());
  EXPECT_NEAR(pressure(turning.stress()), p, 1e-8 * p);
  EXPECT_NEAR(turning.plastic_work(), still.plastic_work(), 1e-8 * still.plastic_work());
}

} // namespace
} // namespace tremolo::materials::test
