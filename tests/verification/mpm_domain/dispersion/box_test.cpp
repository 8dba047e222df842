// Reduced dispersion in a flat box shaken through its faces by an oblique SV wave of 3 Hz, 32 m long at the
// peak of its spectrum: faces, free surface and corners included.

#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo {
namespace {

using test_support::BoxResult;

BoxResult run(double h, double angle_deg, mpm_domain::Dispersion dispersion) {
  mpm_domain::Scheme scheme;
  scheme.fraction = 0.95;
  scheme.dispersion = dispersion;
  return test_support::run_box(h, angle_deg, true, scheme);
}

TEST(ReducedDispersionBox, ObliqueWave) {
  const BoxResult coarse = run(2.0, 15.0, mpm_domain::Dispersion::reduced);
  const BoxResult fine = run(1.0, 15.0, mpm_domain::Dispersion::reduced);
  const BoxResult plain = run(1.0, 15.0, mpm_domain::Dispersion::plain);
  EXPECT_LT(coarse.error, 0.015);
  EXPECT_LT(fine.error, 0.003);
  EXPECT_LT(fine.error, plain.error / 8.0);
  // The faces of the sides are of second order for waves that do not go along them.
  EXPECT_GT(std::log2(coarse.error / fine.error), 2.2);
  EXPECT_LT(fine.residual, 1.05 * plain.residual);
  EXPECT_LE(fine.dashpots, 0.0);
}

TEST(ReducedDispersionBox, OtherAngles) {
  EXPECT_LT(run(1.0, 0.0, mpm_domain::Dispersion::reduced).error, 0.005);
  EXPECT_LT(run(1.0, 30.0, mpm_domain::Dispersion::reduced).error, 0.005);
}

TEST(ReducedDispersionBox, BetweenMatchedLayers) {
  using mpm_domain::Side;
  mpm_domain::Scheme scheme;
  scheme.fraction = 0.95;
  scheme.dispersion = mpm_domain::Dispersion::reduced;
  const BoxResult all_round =
      test_support::run_box(1.0, 15.0, true, scheme, {Side::left, Side::right, Side::base});
  EXPECT_LT(all_round.error, 0.005);
}

} // namespace
} // namespace tremolo
