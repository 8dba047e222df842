// A layer of c-phi soil on rock, dry or with water that seeps along it. Without ends it slides as a block,
//
//     F = [c + (gamma - m gamma_w) z cos^2 b tan phi]/(gamma z sin b cos b)
//
// (Taylor 1948, Fundamentals of Soil Mechanics, ch. 16), z being its vertical thickness and m z the depth of
// the water in it. A layer of length L between held ends is carried by them as well, by forces that do not
// depend on L once it is long for its thickness,
//
//     F(L) = F + a z/L,      so that      F = 2 F(2 L) - F(L).
//
// The force on the grains of a seeping layer leans by atan(gamma/gamma' tan b) from the normal of the slope,
// and the more it leans, the longer is the wedge at the lower end that resists. On a slope of 20 degrees that
// are 35 degrees and 15 m, half of a layer of 30 m. The seeping layer has 10 degrees, on which the force
// leans as in the dry layer of 20 degrees.

#include "mpm_domain/gravity/strength_reduction.hpp"
#include "tests/support/hard_case.hpp"
#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace tremolo::mpm_domain {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double dry_slope = 20.0 * degree;
constexpr double seeping_slope = 10.0 * degree;
constexpr double friction = 30.0 * degree;
constexpr double cohesion = 5e3;        // Pa
constexpr double thickness = 4.0;       // m
constexpr double unit_weight = 20e3;    // N/m3, saturated or dry
constexpr double water_weight = 9810.0; // N/m3
constexpr double cell = 0.5;            // m

double slope_of(bool wet) {
  return wet ? seeping_slope : dry_slope;
}

/// @param wet  m: 0 or 1
double closed_form(bool wet) {
  const double slope = slope_of(wet);
  const double effective = unit_weight - (wet ? water_weight : 0.0);
  return (cohesion + effective * thickness * std::pow(std::cos(slope), 2) * std::tan(friction)) /
         (unit_weight * thickness * std::sin(slope) * std::cos(slope));
}

/// @param length  along x, m
Spec layer_on_rock(double length, bool wet) {
  const double fall = length * std::tan(slope_of(wet));
  const double base = -std::ceil(fall + thickness) - 1.0;
  const double density = unit_weight / test::gravity;
  Spec spec;
  spec.box = {0.0, base, length, 0.0};
  spec.cell_size = cell;
  spec.gravity = test::gravity;
  spec.soils = {{"layer", test::perfectly_plastic({density, 100e6, 0.3}, cohesion, friction)},
                {"rock", materials::LinearElastic{{density, 100e6, 0.3}}}};
  spec.regions = {{0, {{0.0, base}, {length, base}, {length, -fall}, {0.0, 0.0}}},
                  {1, {{0.0, base}, {length, base}, {length, -fall - thickness}, {0.0, -thickness}}}};
  if (wet) {
    const materials::PoreFluid water;
    constexpr double porosity = 0.4;
    for (Soil& soil : spec.soils)
      soil.pores = {.porosity = porosity,
                    .grain_density = (density - porosity * water.density) / (1.0 - porosity),
                    .permeability = soil.name == "rock" ? 1e-10 : 1e-4,
                    .drainage = materials::Drainage::drained};
    spec.water = {.level = 0.0, .fluid = water, .line = {}, .seepage = SideLevels{0.0, -fall}};
  }
  return spec;
}

/// Whether water seeps along the layer.
class InfiniteSlope : public testing::TestWithParam<bool> {};

/// Held ends only help, by less than a quarter where the layer is 7.5 times as long as thick.
TEST_P(InfiniteSlope, StandsWithItsFactorBetweenHeldEnds) {
  const Spec spec = layer_on_rock(30.0, GetParam());
  const double expected = closed_form(GetParam());
  EXPECT_TRUE(try_factor(spec, expected, [](const StrengthTrial&) {}).stands);
  EXPECT_TRUE(try_factor(spec, 1.25 * expected, [](const StrengthTrial&) {}).fails);
}

INSTANTIATE_TEST_SUITE_P(Waters, InfiniteSlope, testing::Bool(),
                         [](const auto& wet) { return std::string(wet.param ? "seeping" : "dry"); });

class AcceptanceInfiniteSlope : public testing::TestWithParam<bool> {};

TEST_P(AcceptanceInfiniteSlope, HasItsFactorWhereItHasNoEnds) {
  const bool wet = GetParam();
  const auto factor = [wet](double length) {
    const auto found = factor_of_safety(layer_on_rock(length, wet), 0.005, [](const StrengthTrial&) {});
    return 0.5 * (*found.stands + *found.fails);
  };
  const double shorter = factor(30.0);
  const double longer = factor(60.0);
  test_support::bounded(std::string("factor of safety of the ") + (wet ? "seeping" : "dry") +
                            " layer without ends off the closed form",
                        std::abs((2.0 * longer - shorter) / closed_form(wet) - 1.0), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Waters, AcceptanceInfiniteSlope, testing::Bool(),
                         [](const auto& wet) { return std::string(wet.param ? "seeping" : "dry"); });

} // namespace
} // namespace tremolo::mpm_domain
