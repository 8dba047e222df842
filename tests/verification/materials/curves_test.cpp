// Darendeli's curves against values printed in his thesis, and the MKZ fit against curves whose parameters
// are known.

#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/hysteretic/backbone/curve_fit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tremolo::materials {
namespace {

constexpr double atm = 101325.0;

// Tables 10.13 and 10.14 of the thesis: PI = 30 %, OCR = 1, 0.25 atm, 1 Hz, 10 cycles.
TEST(DarendeliCurves, AreThoseOfTheThesis) {
  const Darendeli soil = {.plasticity_index = 30.0, .mean_effective_stress = 0.25 * atm};
  const SoilCurves curves = darendeli_curves(soil, std::array{1e-7, 2.2e-5, 1e-2});
  const std::array modulus = {1.0, 0.936, 0.050};
  const std::array damping = {0.01778, 0.02476, 0.21542};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(curves.modulus_ratio[i], modulus[i], 0.001); // printed with three decimals
    EXPECT_NEAR(curves.damping_ratio[i] / damping[i], 1.0, 0.003);
  }
}

TEST(DarendeliCurves, HaveTheirReferenceStrainAtOneAtmosphere) {
  const Darendeli sand = {.plasticity_index = 0.0, .mean_effective_stress = atm};
  EXPECT_NEAR(sand.reference_strain(), 3.52e-4, 1e-12);
  EXPECT_NEAR(sand.modulus_ratio_at(sand.reference_strain()), 0.5, 1e-12);
  EXPECT_NEAR(sand.least_damping(), 0.008005, 1e-12);
}

TEST(SoilCurves, AreLinearInTheLogarithmOfStrain) {
  const SoilCurves table = {{1e-5, 1e-3}, {1.0, 0.4}, {0.01, 0.15}};
  EXPECT_NEAR(table.modulus_ratio_at(1e-4), 0.7, 1e-12);
  EXPECT_NEAR(table.damping_ratio_at(1e-4), 0.08, 1e-12);
  EXPECT_EQ(table.modulus_ratio_at(0.0), 1.0);
  EXPECT_EQ(table.damping_ratio_at(0.1), 0.15);
}

TEST(MkzFit, FindsTheParametersThatMadeTheCurve) {
  for (const double exponent : {0.6, 0.919, 1.0}) {
    const Backbone made = {1.0, 7e-4, 1.0, exponent};
    SoilCurves curves;
    for (double strain = 1e-6; strain < 0.1; strain *= 1.5) {
      curves.strain.push_back(strain);
      curves.modulus_ratio.push_back(made.secant(strain));
      curves.damping_ratio.push_back(0.0);
    }
    const MkzFit fit = fit_mkz(curves);
    EXPECT_NEAR(fit.reference_strain / 7e-4, 1.0, 1e-7);
    EXPECT_NEAR(fit.exponent, exponent, 1e-7);
    EXPECT_LT(fit.largest_residual, 1e-8);
    const MkzFit kept = fit_mkz(curves, 2e-4);
    EXPECT_EQ(kept.reference_strain, 2e-4);
    EXPECT_NEAR(kept.beta, std::pow(2.0 / 7.0, exponent), 1e-7);
  }
}

TEST(MkzFit, HoldsTheExponentWhereTheStressWouldFall) {
  SoilCurves curves;
  for (double strain = 1e-6; strain < 0.1; strain *= 2.0) {
    curves.strain.push_back(strain);
    curves.modulus_ratio.push_back(1.0 / (1.0 + std::pow(strain / 1e-3, 1.3)));
    curves.damping_ratio.push_back(0.0);
  }
  const MkzFit fit = fit_mkz(curves);
  EXPECT_EQ(fit.exponent, 1.0);
  EXPECT_TRUE(fit.exponent_at_limit);
  EXPECT_GT(fit.largest_residual, 0.01);
  // The least squares for s = 1: no other gamma_r does better.
  const auto sum = [&](double reference) {
    double squares = 0.0;
    for (std::size_t i = 0; i < curves.strain.size(); ++i) {
      squares += std::pow(1.0 / (1.0 + curves.strain[i] / reference) - curves.modulus_ratio[i], 2);
    }
    return squares;
  };
  EXPECT_LT(sum(fit.reference_strain), sum(1.001 * fit.reference_strain));
  EXPECT_LT(sum(fit.reference_strain), sum(0.999 * fit.reference_strain));
}

// Known from practice: Masing damping is too small at small strain and too large at large strain.
TEST(MasingAgainstCurve, LacksDampingAtSmallAndHasTooMuchAtLargeStrain) {
  const SoilCurves curves = darendeli_curves({.plasticity_index = 15.0, .mean_effective_stress = atm});
  const MkzFit fit = fit_mkz(curves);
  EXPECT_NEAR(fit.exponent, 0.919, 1e-6);
  const auto both = masing_against(curves, fit);
  EXPECT_LT(both.front().masing, 0.1 * both.front().curve);
  EXPECT_GT(both.back().masing, 1.5 * both.back().curve);
}

} // namespace
} // namespace tremolo::materials
