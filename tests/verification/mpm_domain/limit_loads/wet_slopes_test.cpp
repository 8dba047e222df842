// A slope of 3 to 1 with water in it or over it, phi = 30 degrees, c = 0.025 gamma H, gamma = 2 gamma_w,
// through whose toe the slip circles go. Bishop's method (1955, Geotechnique 5, 7-17), with a search for the
// circle of the least factor, gives
//
//     dry 2.256,      under water, at rest, to above its crest 2.58,
//     and with the pressure ratio r_u = p/(gamma z) = 0.5 everywhere 1.200 (Bishop and Morgenstern 1960).
//
// Water below a line along the ground has p = gamma_w z, which is r_u = gamma_w/gamma.

#include "mpm_domain/gravity/strength_reduction.hpp"
#include "tests/verification/mpm_domain/limit_loads/slope.hpp"
#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {
namespace {

using test::height;

Spec wet_slope(double cell, double share = 1.0) {
  constexpr double density = 2000.0; // saturated
  Spec spec = test::spec_of(test::Slope{std::atan(1.0 / 3.0) / test::degree, 1.5, cell},
                            test::perfectly_plastic({density, 100e6, 0.3},
                                                    0.025 * density * test::gravity * height / share,
                                                    std::atan(std::tan(std::numbers::pi / 6.0) / share)));
  spec.soils.front().pores = {.porosity = (2650.0 - density) / 1650.0,
                              .grain_density = 2650.0,
                              .permeability = 1e-5,
                              .drainage = materials::Drainage::drained};
  return spec;
}

/// The upper edge of the ground, which the region ends with, from left to right.
std::vector<Vector> along_ground(const Spec& spec) {
  const std::vector<Vector>& polygon = spec.regions.front().polygon;
  std::vector<Vector> line;
  for (auto corner = polygon.rbegin(); corner != polygon.rend() && corner->y >= 0.0; ++corner)
    line.push_back(*corner);
  return line;
}

double factor(const Spec& spec) {
  const auto found = factor_of_safety(spec, 0.02, [](const StrengthTrial&) {});
  return 0.5 * (*found.stands + *found.fails);
}

TEST(WetSlope, StandsOrFailsByThePressureInIt) {
  const auto stands = [](double share) {
    Spec spec = wet_slope(1.0, share);
    spec.water = {.level = height, .fluid = {}, .line = along_ground(spec)};
    return test::carries_its_weight(spec, 8.0);
  };
  EXPECT_TRUE(stands(1.2 * 0.92));
  EXPECT_FALSE(stands(1.2 * 1.10));
}

TEST(AcceptanceWetSlope, HasTheFactorsOfBishop) {
  Spec spec = wet_slope(1.0);
  spec.water = {.level = height, .fluid = {}, .line = along_ground(spec)};
  EXPECT_NEAR(factor(spec), 1.200, 0.03 * 1.200);
  spec.water = {.level = height + 5.0, .fluid = {}};
  EXPECT_NEAR(factor(spec), 2.58, 0.03 * 2.58);
  spec = wet_slope(1.0);
  spec.soils.front().pores.reset();
  EXPECT_NEAR(factor(spec), 2.256, 0.03 * 2.256);
}

} // namespace
} // namespace tremolo::mpm_domain
