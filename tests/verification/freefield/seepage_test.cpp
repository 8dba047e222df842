// Water that is driven through the two-phase column from below: a head that falls as water leaves its tube,
// and the gradient at which sand loses its weight.

#include "tests/support/saturated_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::freefield::testing {
namespace {

/// The head in a tube of a tenth of the soil's area falls as h = h0 exp(-10 k t/L), L and k of two layers in
/// series.
TEST(Seepage, FallingHeadIsAnExponential) {
  const Profile profile = wet_profile({wet_layer(0.5, 1e9, 1e-3), wet_layer(0.5, 1e9, 4e-3, 0.5)});
  auto settings = wet_settings(profile, 0.1);
  constexpr double area_ratio = 10.0, first_head = 0.5;
  const double conductance = 1.0 / (0.5 / 1e-3 + 0.5 / 4e-3); // k/L, 1/s
  double head = first_head;
  settings.base_pressure = [&head](double) { return unit_weight * head; };
  TwoPhaseColumn column(profile, settings, at_rest);
  double begin = 0.0, head_then = 0.0;
  for (const double time : {0.05, 20.0, 60.0}) {
    while (column.time() < time - 0.5 * column.time_step()) {
      column.step();
      head -= area_ratio * column.flux().front() * column.time_step();
    }
    if (time < 1.0) { // steady flow has come
      begin = column.time();
      head_then = head;
      EXPECT_NEAR(head, first_head, 0.01 * first_head);
      continue;
    }
    const double exact = head_then * std::exp(-area_ratio * conductance * (column.time() - begin));
    EXPECT_NEAR(head, exact, 0.002 * exact) << time;
  }
}

/// Upward flow takes the effective stress of all the ground at the gradient (gamma_sat - gamma_w)/gamma_w.
TEST(Seepage, SandLosesItsWeightAtTheCriticalGradient) {
  constexpr double height = 5.0;
  const Profile profile = wet_profile({wet_layer(height, 1e8, 1e-3)});
  const double buoyant = materials::buoyant_density(*profile.layers[0].pores, water) * gravity;
  auto settings = wet_settings(profile, 0.5);
  double gradient = 0.0;
  constexpr double rate = 0.01; // 1/s, slow against consolidation
  settings.base_pressure = [&](double time) {
    gradient = std::min(rate * time, 0.98);
    return gradient * unit_weight * height;
  };
  TwoPhaseColumn column(profile, settings, at_rest);
  for (const double time : {30.0, 60.0}) {
    march(column, time);
    for (const double depth : {0.25, 2.25, 4.75}) {
      const ColumnSample at = sample_at(column, -depth);
      const double left = (buoyant * depth - at.syy - at.pore_pressure) / (buoyant * depth);
      EXPECT_NEAR(left, 1.0 - gradient * unit_weight / buoyant, 0.01) << depth;
    }
  }
  // The gradient at which nothing is left, from the two that were measured.
  march(column, 90.0);
  const double before = gradient;
  const auto weight_left = [&] {
    const ColumnSample at = sample_at(column, -2.25);
    return (buoyant * 2.25 - at.syy - at.pore_pressure) / (buoyant * 2.25);
  };
  const double first = weight_left();
  march(column, 95.0);
  const double critical = before + (gradient - before) * first / (first - weight_left());
  EXPECT_NEAR(critical, buoyant / unit_weight, 0.01 * buoyant / unit_weight);
}

} // namespace
} // namespace tremolo::freefield::testing
