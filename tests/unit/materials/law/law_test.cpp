// What is asked of any law: traits, and the operations that a law has or leaves at their default.

#include "materials/law/defaults.hpp"
#include "materials/law/law.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <vector>

namespace tremolo::materials::test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr Elasticity elastic = {1800.0, 60e6, 0.3};

MohrCoulomb softening_soil() {
  return {.elastic = elastic,
          .cohesion_peak = 5e3,
          .cohesion_residual = 1e3,
          .friction_peak = 0.6,
          .friction_residual = 0.5,
          .softening = 15.0};
}

Pm4Sand pm4() {
  return pm4sand({.density = 1900.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4});
}

std::vector<Law> all_laws() {
  return {LinearElastic{elastic},
          softening_soil(),
          MasingShear{elastic, 1e-3},
          iwan_shear(elastic, 1e-3, 1.0, 1.0),
          DruckerPrager{elastic, 5e3, 0.6, 0.1},
          multi_yield_clay({1800.0, 60e6, 0.49}, 30e3),
          pm4(),
          pdmy03(pdmy03_recommended(0.57))};
}

/// What holds for every law, whatever it is.
TEST(Laws, AgreeWithTheirTraits) {
  ASSERT_EQ(all_laws().size(), std::variant_size_v<Laws>);
  for (const Law& law : all_laws()) {
    const Traits like = traits(law);
    SCOPED_TRACE(like.name);
    EXPECT_EQ(state_variables(law).empty(), like.response == Response::elastic);
    EXPECT_EQ(traits(without_softening(law)).softening, 0.0);
    EXPECT_TRUE(like.remembers_initial_stress || !like.follows_pressure);
    EXPECT_FALSE(like.total_stress && like.follows_pressure);
    if (shear_backbone(law)) {
      EXPECT_DOUBLE_EQ(shear_backbone(law)->shear_modulus, elasticity(law).shear_modulus());
    }
    const Law finer = for_cell_size(law, 0.5, 1.0);
    EXPECT_DOUBLE_EQ(traits(finer).softening, 0.5 * like.softening);
    EXPECT_EQ(traits(finer).name, like.name);
  }
}

TEST(Laws, ALawThatSoftensIsItselfAtItsReferenceSize) {
  const Law law = softening_soil();
  EXPECT_EQ(traits(law).softening, 15.0);
  EXPECT_EQ(traits(for_cell_size(law, 0.25, 0.25)).softening, 15.0);
  EXPECT_THAT([&] { for_cell_size(law, 0.0, 1.0); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("cell size")));
}

TEST(Laws, TheContractionRateIsThatOfPm4Sand) {
  const Law sand = pm4();
  EXPECT_EQ(contraction_rate(sand), 0.4);
  EXPECT_EQ(contraction_rate(with_contraction_rate(sand, 0.7)), 0.7);
  EXPECT_EQ(relative_density(sand), 0.55);
  const Law other = LinearElastic{elastic};
  EXPECT_EQ(contraction_rate(other), std::nullopt);
  EXPECT_EQ(relative_density(other), std::nullopt);
  EXPECT_THAT([&] { with_contraction_rate(other, 0.7); },
              ThrowsMessage<std::invalid_argument>("linear_elastic has no contraction rate"));
}

TEST(Laws, FailureLinesAreThoseOfTheirStrength) {
  const double p = 40e3;
  // s1 - s3 = 2 c cos(phi) + 2 p sin(phi)
  EXPECT_DOUBLE_EQ(strength_lines(Law(softening_soil())).at(0).q_of_p(p),
                   2.0 * (5e3 * std::cos(0.6) + p * std::sin(0.6)));
  // s1 - s3 = sqrt(3) s_u in a triaxial test, whatever the pressure
  const Law clay = multi_yield_clay({1800.0, 60e6, 0.49}, 30e3);
  EXPECT_DOUBLE_EQ(strength_lines(clay).at(0).q_of_p(p), std::sqrt(3.0) * 30e3);
  // M = 2 sin(phi_cv), phi_cv = 33 degrees by default
  const Law sand = pm4();
  EXPECT_EQ(strength_lines(sand).at(0).name, "critical_state");
  EXPECT_NEAR(strength_lines(sand).at(0).q_of_p(p), 2.0 * std::sin(33.0 * std::acos(-1.0) / 180.0) * p, 1e-6);
  EXPECT_TRUE(strength_lines(Law(LinearElastic{elastic})).empty());
}

/// By a factor, as slopes are judged: c/F and tan(phi)/F, and no more dilation than friction.
TEST(Laws, StrengthIsReducedWhereSoilFailsAtRest) {
  const Law reduced = with_reduced_strength(softening_soil(), 2.0).value();
  const auto& soil = std::get<MohrCoulomb>(reduced);
  EXPECT_DOUBLE_EQ(soil.cohesion_peak, 2.5e3);
  EXPECT_DOUBLE_EQ(soil.cohesion_residual, 0.5e3);
  EXPECT_DOUBLE_EQ(std::tan(soil.friction_peak), 0.5 * std::tan(0.6));
  EXPECT_DOUBLE_EQ(std::tan(soil.friction_residual), 0.5 * std::tan(0.5));
  EXPECT_EQ(soil.softening, 15.0);
  const DruckerPrager cone = with_reduced_strength(DruckerPrager{elastic, 5e3, 0.6, 0.6}, 2.0).value();
  EXPECT_DOUBLE_EQ(cone.cohesion, 2.5e3);
  EXPECT_DOUBLE_EQ(std::tan(cone.friction), 0.5 * std::tan(0.6));
  EXPECT_DOUBLE_EQ(cone.dilation, cone.friction);
  for (const Law& law : all_laws())
    EXPECT_EQ(with_reduced_strength(law, 2.0).has_value(), !std::holds_alternative<LinearElastic>(law) &&
                                                               !std::holds_alternative<MasingShear>(law) &&
                                                               !std::holds_alternative<IwanShear>(law))
        << name(law);
}

/// Laws that carry any load at rest have a strength as well: what their soil fails with under a load that
/// stays.
TEST(Laws, SoilOfShakenLawsIsReducedToItsStrength) {
  const auto undrained_strength = [](const Law& law) {
    const auto soil = std::get<DruckerPrager>(with_reduced_strength(law, 2.0).value());
    EXPECT_EQ(soil.friction, 0.0);
    EXPECT_EQ(soil.elastic.young, elasticity(law).young);
    EXPECT_EQ(soil.elastic.at_rest, elasticity(law).at_rest);
    return soil.cohesion;
  };
  const Law clay = with_rest_coefficient(multi_yield_clay({1800.0, 60e6, 0.49}, 30e3), 0.7);
  EXPECT_DOUBLE_EQ(undrained_strength(clay), 15e3);
  // s1 - s3 = 2 s_u/F in plane strain, whatever the pressure: sqrt(J2) = s_u/F
  EXPECT_DOUBLE_EQ(cone(std::get<DruckerPrager>(with_reduced_strength(clay, 2.0).value())).strength, 15e3);
  EXPECT_EQ(cone(std::get<DruckerPrager>(with_reduced_strength(clay, 2.0).value())).slope, 0.0);

  IwanShear hyperbola = iwan_shear(elastic, 1e-3, 1.0, 1.0);
  EXPECT_FALSE(
      with_reduced_strength(hyperbola, 2.0)); // what the curve implies at large strain does not count
  hyperbola.strength = 20e3;
  EXPECT_DOUBLE_EQ(undrained_strength(hyperbola), 10e3);

  const MohrCoulomb sand = with_reduced_strength(pm4(), 2.0).value();
  EXPECT_DOUBLE_EQ(std::tan(sand.friction_peak), 0.5 * std::tan(33.0 * std::acos(-1.0) / 180.0));
  EXPECT_EQ(sand.friction_residual, sand.friction_peak);
  EXPECT_EQ(sand.cohesion_peak, 0.0);
  EXPECT_EQ(sand.dilation_peak, 0.0);
}

/// A law of its own, as somebody adds it, that says nothing beyond what every law must.
struct Bare {
  Elasticity elastic;
};
Traits traits(const Bare& /*law*/) {
  return {.name = "bare"};
}

TEST(Laws, ALawThatSaysNoMoreHasTheDefaults) {
  const Bare law = {elastic};
  EXPECT_EQ(defaults::p_wave_speed_bound(law, Points{}), elastic.p_wave_speed());
  EXPECT_EQ(&defaults::without_softening(law), &law);
  EXPECT_EQ(&defaults::after_shaking(law), &law);
  EXPECT_EQ(&defaults::for_cell_size(law, 0.5, 1.0), &law);
  EXPECT_FALSE(defaults::with_reduced_strength(law, 2.0).has_value());
  EXPECT_TRUE(defaults::notes(law).empty());
  EXPECT_THAT([&] { defaults::with_contraction_rate(law, 1.0); },
              ThrowsMessage<std::invalid_argument>("bare has no contraction rate"));
}

} // namespace
} // namespace tremolo::materials::test
