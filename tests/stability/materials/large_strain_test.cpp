// Hysteretic laws under strains that no earthquake passes: cycles of 5 %, a hundred thousand steps, strains
// far beyond the backbone's range with large rotations.

#include "materials/hysteretic/masing.hpp"
#include "materials/law/driver.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace tremolo::materials {
namespace {

const Elasticity elastic = {1900.0, 130e6, 0.499};

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

bool finite(const PointTest& point) {
  const PointStress& s = point.stress();
  return std::isfinite(s.xx) && std::isfinite(s.yy) && std::isfinite(s.zz) && std::isfinite(s.xy) &&
         std::isfinite(point.plastic_work());
}

TEST(LargeStrain, CyclesOfFivePerCentStayInsideTheBackboneAndDissipate) {
  const Backbone backbone = {elastic.shear_modulus(), 3e-4, 1.0, 0.9};
  for (const Law& law :
       {Law(MasingShear{elastic, 3e-4, 1.0, 0.9}), Law(iwan_shear(elastic, 3e-4, 1.0, 0.9))}) {
    PointTest point(law, {-50e3, -100e3, -50e3, 0.0});
    double work = 0.0;
    for (int k = 1; k <= 20000; ++k) {
      const double strain = 0.05 * std::sin(2.0 * std::numbers::pi * k / 200.0);
      point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(strain - point.strain().xy)});
      ASSERT_TRUE(finite(point));
      ASSERT_LE(std::abs(point.stress().xy), backbone.stress(0.05) * 1.002);
      if (k % 200 == 0) { // a closed loop dissipates what the last one did
        const double loop = point.plastic_work() - work;
        work = point.plastic_work();
        if (k > 200) {
          const double formula =
              masing_damping(backbone, 0.05) * 2.0 * std::numbers::pi * 0.05 * backbone.stress(0.05);
          EXPECT_NEAR(loop / formula, 1.0, 0.01) << name(law);
        }
      }
    }
  }
}

TEST(LargeStrain, IwanElementsNeverLeaveTheirCircle) {
  const IwanShear law = iwan_shear(elastic, 3e-4, 1.0, 0.9);
  PointTest point(law, {-50e3, -100e3, -50e3, 0.0});
  std::mt19937_64 random(21);
  for (int k = 0; k < 5000; ++k) {
    const double size = std::pow(10.0, between(random, -7.0, 0.0));
    PointStep step = {Control::strain(size * between(random, -1.0, 1.0)),
                      Control::strain(size * between(random, -1.0, 1.0)),
                      Control::strain(size * between(random, -1.0, 1.0))};
    step.rotation = between(random, -3.0, 3.0);
    point.apply(step);
    ASSERT_TRUE(finite(point));
    for (std::size_t i = 0; i < law.elements.size(); ++i) {
      const double* s = &point.state()[3 * (i - i % iwan_group) + i % iwan_group];
      const double xx = s[0];
      const double yy = s[iwan_group];
      const double xy = s[2 * iwan_group];
      ASSERT_LE(std::sqrt(xx * xx + yy * yy + xx * yy + xy * xy), law.elements[i].strength * (1.0 + 1e-12));
    }
  }
}

TEST(LargeStrain, AHundredThousandRandomTurnsDoNotWearTheMemoryOut) {
  const Backbone backbone = {50e6, 3e-4, 1.0, 0.9};
  std::array<double, masing_history_size> history{};
  std::mt19937_64 random(22);
  for (int k = 0; k < 100000; ++k) {
    const double size = std::pow(10.0, between(random, -15.0, 0.0));
    masing_commit(backbone, history, size * between(random, -1.0, 1.0));
    ASSERT_TRUE(std::isfinite(history[masing::stress]));
    ASSERT_LE(history[masing::reversals], static_cast<double>(masing_capacity));
    ASSERT_LE(std::abs(history[masing::stress]), backbone.stress(1.0) * (1.0 + 1e-12));
  }
}

} // namespace
} // namespace tremolo::materials
