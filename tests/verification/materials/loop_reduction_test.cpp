// Unloading with less damping than the Masing rules have (MRDF), in columns and in the elements of the
// domain.

#include "materials/hysteretic/backbone/loop_fit.hpp"
#include "materials/hysteretic/masing.hpp"
#include "materials/law/driver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace tremolo::materials {
namespace {

const Elasticity elastic = {1900.0, 130e6, 0.3};
constexpr LoopReduction loops = {0.85, 0.45, 0.6};

using History = std::array<double, masing_history_size>;

Backbone backbone(const LoopReduction& reduction = loops) {
  return {elastic.shear_modulus(), 5e-4, 1.0, 0.92, std::nullopt, reduction};
}

TEST(LoopReduction, OfNothingIsTheMasingRules) {
  const Backbone plain = backbone({});
  const Backbone one = backbone({1.0, 0.0, 3.0});
  std::mt19937_64 random(1);
  History history{};
  for (int k = 0; k < 1000; ++k) {
    const double strain = std::uniform_real_distribution<double>(-2e-3, 2e-3)(random);
    ASSERT_EQ(masing_stress(one, history, strain), masing_stress(plain, history, strain));
    masing_commit(plain, history, strain);
  }
}

/// Phillips & Hashash (2009) after the reversal of a first loading to `tip`.
double first_unloading(const Backbone& curve, double tip, double strain) {
  const double secant = curve.stress(tip) / tip;
  const double factor = curve.loops.at_small_strain -
                        curve.loops.loss * std::pow(1.0 - secant / curve.shear_modulus, curve.loops.exponent);
  const double change = strain - tip;
  return factor * (2.0 * curve.stress(0.5 * change) - secant * change) + secant * change + curve.stress(tip);
}

TEST(LoopReduction, IsTheFormulaOfPhillipsAndHashash) {
  const Backbone curve = backbone();
  for (const double tip : {1e-5, 3e-4, 1e-2}) {
    History history{};
    masing_commit(curve, history, tip);
    for (double share = 0.95; share > -1.0; share -= 0.1) {
      const auto [stress, tangent] = masing_response(curve, history, share * tip);
      EXPECT_NEAR(stress, first_unloading(curve, tip, share * tip), 1e-12 * curve.stress(tip));
      const double h = 1e-5 * tip;
      EXPECT_NEAR(
          tangent,
          (masing_stress(curve, history, share * tip + h) - masing_stress(curve, history, share * tip - h)) /
              (2.0 * h),
          1e-6 * curve.shear_modulus);
    }
    EXPECT_NEAR(masing_stress(curve, history, -tip), -curve.stress(tip), 1e-12 * curve.stress(tip))
        << "the loop meets the backbone at its other tip";
  }
}

/// Damping ratio of a symmetric loop that was traced.
double traced_damping(const Backbone& curve, double amplitude) {
  constexpr int steps = 4000;
  History history{};
  masing_commit(curve, history, amplitude);
  double area = 0.0;
  for (int k = 1; k <= steps; ++k) {
    const double strain = history[masing::strain];
    const double stress = accepted_stress(curve, history);
    masing_commit(curve, history, amplitude * std::cos(2.0 * std::numbers::pi * k / steps));
    area += 0.5 * (stress + accepted_stress(curve, history)) * (history[masing::strain] - strain);
  }
  return area / (2.0 * std::numbers::pi * amplitude * curve.stress(amplitude));
}

TEST(LoopReduction, DampingOfALoopIsItsShareOfThatOfTheMasingRules) {
  for (const double strain : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const Backbone curve = backbone();
    EXPECT_NEAR(traced_damping(curve, strain) / loop_damping(curve, strain), 1.0, 1e-3);
    EXPECT_LT(loop_damping(curve, strain), 0.85 * masing_damping(curve, strain));
  }
}

TEST(LoopReduction, RandomLoopsStayInsideTheBackboneAndClose) {
  const Backbone curve = backbone();
  std::mt19937_64 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int path = 0; path < 200; ++path) {
    History history{};
    double largest = 0.0;
    double came_from = 0.0;
    for (int k = 0; k < 50; ++k) {
      came_from = history[masing::strain];
      const double strain = std::pow(10.0, between(-5.0, -2.0)) * between(-1.0, 1.0);
      largest = std::max(largest, std::abs(strain));
      const double expected = masing_stress(curve, history, strain);
      masing_commit(curve, history, strain);
      ASSERT_NEAR(accepted_stress(curve, history), expected, 1e-12 * curve.stress(largest));
      ASSERT_LE(std::abs(expected), curve.stress(largest) * (1.0 + 1e-12));
    }
    // A small loop inside closes.
    const double here = history[masing::strain];
    const double before = accepted_stress(curve, history);
    masing_commit(curve, history, here + 0.3 * (came_from - here));
    masing_commit(curve, history, here);
    EXPECT_NEAR(accepted_stress(curve, history), before, 1e-9 * curve.stress(largest));
  }
}

MasingShear masing_law(const Backbone& curve) {
  return {elastic, curve.reference_strain, curve.beta, curve.exponent, curve.shape, curve.loops};
}

PointStep shear(double change) {
  return {Control::strain(0.0), Control::strain(0.0), Control::strain(change)};
}

TEST(LoopReduction, ElementsOfTheDomainFollowTheColumn) {
  const Backbone curve = backbone();
  PointTest column(masing_law(curve), {-50e3, -100e3, -50e3, 8e3});
  PointTest domain(iwan_shear(elastic, curve, {.elements = 60}), {-50e3, -100e3, -50e3, 8e3});
  std::mt19937_64 random(3);
  double largest = 0.0;
  for (int k = 0; k < 2000; ++k) {
    const double target = std::uniform_real_distribution<double>(-4e-3, 4e-3)(random);
    largest = std::max(largest, std::abs(target));
    column.apply(shear(target - column.strain().xy));
    domain.apply(shear(target - domain.strain().xy));
    ASSERT_NEAR(domain.stress().xy, column.stress().xy, 0.004 * curve.stress(largest)) << k;
  }
  EXPECT_NEAR(domain.plastic_work() / column.plastic_work(), 1.0, 0.01);
}

TEST(LoopReduction, FitGivesLoopsTheDampingOfTheCurve) {
  const Darendeli soil = {15.0, 1.0, 101325.0};
  const auto curves = darendeli_curves(soil);
  Backbone curve = {elastic.shear_modulus(), soil.reference_strain(), 1.0, 0.919};
  const LoopReduction fit = fit_loop_reduction(curves, curve);
  EXPECT_NO_THROW(validate(fit));
  curve.loops = fit;
  for (const double strain : {1e-5, 1e-4, 1e-3, 1e-2, 0.1}) {
    const double wanted = curves.damping_ratio_at(strain) - curves.damping_ratio.front();
    EXPECT_NEAR(loop_damping(curve, strain), wanted, 0.01) << strain;
  }
  EXPECT_GT(masing_damping(curve, 1e-2) - curves.damping_ratio_at(1e-2), 0.15)
      << "what the rules alone are off";
}

TEST(LoopReduction, RefusesSharesOutsideZeroToOne) {
  EXPECT_THROW(validate(LoopReduction{1.1, 0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(validate(LoopReduction{0.5, 0.6, 1.0}), std::invalid_argument);
  EXPECT_THROW(validate(LoopReduction{0.5, -0.1, 1.0}), std::invalid_argument);
  EXPECT_THROW(validate(LoopReduction{0.5, 0.1, 0.0}), std::invalid_argument);
}

} // namespace
} // namespace tremolo::materials
