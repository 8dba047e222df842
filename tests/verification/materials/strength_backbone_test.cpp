// The backbone with a given strength (GQ/H), and its fit to curves.

#include "materials/hysteretic/backbone/strength_fit.hpp"
#include "materials/hysteretic/iwan_shear.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tremolo::materials {
namespace {

constexpr QuadraticShape shape = {-5.0, 4.0, 1.0, 1.0, 0.99};
constexpr Backbone unit = {1.0, 1.0, 1.0, 1.0, shape};

/// A row of a table that was integrated numerically with another program.
struct Row {
  double strain, modulus_ratio, stress, damping;
};
constexpr std::array table = {Row{0.01, 0.94615, 0.00946, 0.01144}, Row{0.1, 0.70183, 0.07018, 0.06335},
                              Row{1.0, 0.33333, 0.33333, 0.14277}, Row{10.0, 0.08244, 0.82437, 0.33709},
                              Row{100.0, 0.00980, 0.98019, 0.55716}};

TEST(StrengthBackbone, IsThatOfTheTable) {
  for (const Row& row : table) {
    EXPECT_NEAR(unit.secant(row.strain), row.modulus_ratio, 6e-6) << row.strain;
    EXPECT_NEAR(unit.stress(row.strain), row.stress, 6e-6) << row.strain;
    EXPECT_NEAR(masing_damping(unit, row.strain), row.damping, 6e-6) << row.strain;
  }
}

TEST(StrengthBackbone, IsTheFormulaOfGroholskiEtAl) {
  for (double x = 1e-6; x < 1e4; x *= 3.0) {
    const double power = std::pow(x, shape.fifth);
    const double theta = shape.first + shape.second * shape.fourth * power /
                                           (std::pow(shape.third, shape.fifth) + shape.fourth * power);
    const double stress = 2.0 * x / (1.0 + x + std::sqrt((1.0 + x) * (1.0 + x) - 4.0 * theta * x));
    EXPECT_NEAR(unit.stress(x) / stress, 1.0, 1e-9) << x;
  }
}

TEST(StrengthBackbone, WithoutThetaIsTheHyperbola) {
  const Backbone hyperbola = {60e6, 3e-4};
  const Backbone plain = {60e6, 3e-4, 1.0, 1.0, QuadraticShape{}};
  for (double strain = 1e-9; strain < 1.0; strain *= 7.0) {
    EXPECT_NEAR(plain.stress(strain) / hyperbola.stress(strain), 1.0, 1e-13);
    EXPECT_NEAR(plain.tangent(strain) / hyperbola.tangent(strain), 1.0, 1e-9);
    EXPECT_NEAR(masing_damping(plain, strain), masing_damping(hyperbola, strain), 1e-9);
  }
  EXPECT_EQ(plain.strength(), hyperbola.strength());
}

TEST(StrengthBackbone, TangentIsTheDerivativeOfStress) {
  for (const double x : {-30.0, -0.5, 0.02, 0.999, 1.001, 7.0}) {
    const double h = 1e-4 * std::abs(x);
    EXPECT_NEAR(unit.tangent(x) / ((unit.stress(x + h) - unit.stress(x - h)) / (2.0 * h)), 1.0, 1e-7) << x;
  }
  EXPECT_EQ(unit.tangent(0.0), 1.0);
  EXPECT_EQ(unit.stress(0.0), 0.0);
}

/// Sand and clay of 200 m/s whose strength is a share of the overburden.
struct Ground {
  Darendeli soil;
  double strength_ratio;
};

TEST(StrengthBackbone, FitKeepsToTheCurveAndReachesTheStrength) {
  const double shear_modulus = 1800.0 * 200.0 * 200.0;
  for (const auto& [soil, ratio] : {Ground{{0.0, 1.0, 200e3}, 0.15}, Ground{{15.0, 1.0, 200e3}, 0.3},
                                    Ground{{50.0, 1.0, 200e3}, 0.3}, Ground{{15.0, 1.0, 50e3}, 0.6}}) {
    const double strength = ratio * soil.mean_effective_stress;
    const double reference = strength / shear_modulus;
    const auto curve = darendeli_curves(soil);
    const Backbone backbone = {shear_modulus, reference, 1.0, 1.0, fit_quadratic_shape(curve, reference)};
    for (std::size_t i = 0; i < curve.strain.size() && curve.strain[i] <= largest_fitted_strain; ++i)
      EXPECT_NEAR(backbone.secant(curve.strain[i]) / shear_modulus, curve.modulus_ratio[i], 0.005) << ratio;
    EXPECT_LT(backbone.stress(10.0), strength);
    EXPECT_GT(backbone.stress(0.1), 0.98 * strength);
  }
}

TEST(StrengthBackbone, FitKeepsAStrengthThatTheCurveDoesNotHave) {
  const auto curve = darendeli_curves({50.0, 1.0, 50e3}); // implies several times 7.5 kPa
  const double shear_modulus = 1800.0 * 200.0 * 200.0;
  const Backbone backbone = {shear_modulus, 7.5e3 / shear_modulus, 1.0, 1.0,
                             fit_quadratic_shape(curve, 7.5e3 / shear_modulus)};
  EXPECT_GT(shear_modulus * curve.modulus_ratio_at(1e-2) * 1e-2, 3.0 * 7.5e3);
  EXPECT_GT(backbone.stress(1e-2), 0.99 * 7.5e3);
  EXPECT_LT(backbone.stress(1.0), 7.5e3);
}

TEST(StrengthBackbone, PolygonOfTheElementsLiesAround) {
  const Elasticity elastic = {1900.0, 130e6, 0.3};
  const Backbone backbone = {elastic.shear_modulus(), 5e-4, 1.0, 1.0, shape};
  for (const auto& [elements, bound] : {std::pair{20u, 5e-3}, std::pair{32u, 2e-3}}) {
    const IwanShear law = iwan_shear(elastic, backbone, {.elements = elements});
    for (double strain = 1e-9; strain < 0.1; strain *= 1.01)
      ASSERT_NEAR(monotonic_stress(law, strain) / backbone.stress(strain), 1.0, bound) << strain;
  }
}

TEST(StrengthBackbone, RefusesShapesThatAreNone) {
  EXPECT_THROW(validate(QuadraticShape{1.5, 0.0}), std::invalid_argument);
  EXPECT_THROW(validate(QuadraticShape{0.5, 0.6}), std::invalid_argument);
  EXPECT_THROW(validate(QuadraticShape{0.0, 0.5, -1.0}), std::invalid_argument);
  EXPECT_THROW(validate(QuadraticShape{-200.0, 200.9, 5.0, 1.0, 3.0}), std::invalid_argument)
      << "its stress rises ever faster where theta does";
  EXPECT_NO_THROW(validate(shape));
}

} // namespace
} // namespace tremolo::materials
