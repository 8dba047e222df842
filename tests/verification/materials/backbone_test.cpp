// Backbone points and the damping of the symmetric Masing loop: against the reference table, and against the
// area of loops that the history itself traced.

#include "materials/hysteretic/masing.hpp"
#include "tests/support/reference_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace tremolo::materials {
namespace {

constexpr double gamma_r = 3e-4;
constexpr Backbone hyperbola = {60e6, gamma_r, 1.0, 1.0};
constexpr Backbone mkz = {60e6, gamma_r, 1.0, 0.919};

TEST(Backbone, PassesThroughHandPoints) {
  const double tau_r = 60e6 * gamma_r;
  EXPECT_NEAR(hyperbola.stress(gamma_r), tau_r / 2.0, 1e-9 * tau_r);
  EXPECT_NEAR(hyperbola.stress(-3.0 * gamma_r), -0.75 * tau_r, 1e-9 * tau_r);
  EXPECT_NEAR(mkz.secant(gamma_r), 30e6, 1.0);
  // Matasovic & Vucetic's beta and s: G/G0 = 1/(1 + 1.4 * 0.1^0.8)
  EXPECT_NEAR((Backbone{1.0, 1.0, 1.4, 0.8}.secant(0.1)), 1.0 / (1.0 + 1.4 * std::pow(10.0, -0.8)), 1e-14);
  EXPECT_EQ(hyperbola.stress(0.0), 0.0);
  EXPECT_EQ(mkz.tangent(0.0), 60e6);
  EXPECT_EQ(hyperbola.strength(), tau_r);
  EXPECT_TRUE(std::isinf(mkz.strength()));
}

TEST(Backbone, TangentIsTheDerivativeOfStress) {
  for (const Backbone& backbone : {hyperbola, mkz, Backbone{60e6, gamma_r, 1.4, 0.7}}) {
    for (const double x : {-30.0, -0.5, 0.02, 1.0, 7.0}) {
      const double strain = x * gamma_r;
      const double h = 1e-4 * std::abs(strain);
      const double difference = (backbone.stress(strain + h) - backbone.stress(strain - h)) / (2.0 * h);
      EXPECT_NEAR(backbone.tangent(strain) / difference, 1.0, 1e-7);
    }
  }
}

TEST(MasingDamping, IsThatOfTheReferenceTable) {
  const auto file = tremolo::testing::reference_folder() / "waves" / "masing_damping.csv";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto rows = tremolo::testing::read_table(file);
  ASSERT_GT(rows.size(), 20u);
  for (const auto& row : rows) {
    const double strain = row[0] * gamma_r;
    EXPECT_NEAR(hyperbola.secant(strain) / 60e6, row[1], 1e-9) << "x = " << row[0];
    EXPECT_NEAR(masing_damping(hyperbola, strain), row[2], 1e-9) << "x = " << row[0];
    EXPECT_NEAR(masing_damping(mkz, strain), row[3], 1e-9) << "x = " << row[0];
  }
}

/// Damping ratio from the area of one symmetric loop, traced by the history in even steps of the loop's
/// phase.
double traced_damping(const Backbone& backbone, double amplitude, int steps) {
  std::array<double, masing_history_size> history{};
  masing_commit(backbone, history, amplitude);
  const double top = history[masing::stress];
  double area = 0.0;
  for (int k = 1; k <= steps; ++k) {
    const double strain = history[masing::strain];
    const double stress = history[masing::stress];
    masing_commit(backbone, history, amplitude * std::cos(2.0 * std::numbers::pi * k / steps));
    area += 0.5 * (stress + history[masing::stress]) * (history[masing::strain] - strain);
  }
  EXPECT_NEAR(history[masing::stress], top, 1e-12 * top) << "the loop closes";
  return area / (2.0 * std::numbers::pi * amplitude * top);
}

TEST(MasingDamping, IsTheAreaOfTracedLoops) {
  for (const Backbone& backbone : {hyperbola, mkz, Backbone{60e6, gamma_r, 1.4, 0.8}}) {
    for (const double x : {0.01, 0.1, 1.0, 10.0, 100.0}) {
      const double formula = masing_damping(backbone, x * gamma_r);
      EXPECT_NEAR(traced_damping(backbone, x * gamma_r, 2000) / formula, 1.0, 1e-3);
    }
  }
}

TEST(MasingDamping, TracedLoopsConvergeAtSecondOrder) {
  const double formula = masing_damping(mkz, gamma_r);
  const double coarse = std::abs(traced_damping(mkz, gamma_r, 500) - formula);
  const double fine = std::abs(traced_damping(mkz, gamma_r, 1000) - formula);
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.1);
}

TEST(MasingDamping, HoldsFromTheSmallestToTheLargestStrain) {
  // Series of the hyperbola at small strain, 2x/(3 pi); limit 2/pi at large strain.
  EXPECT_NEAR(masing_damping(hyperbola, 1e-12 * gamma_r) / (2e-12 / (3.0 * std::numbers::pi)), 1.0, 1e-10);
  EXPECT_NEAR(masing_damping(hyperbola, 1e9 * gamma_r), 2.0 / std::numbers::pi, 1e-7);
  EXPECT_EQ(masing_damping(hyperbola, 0.0), 0.0);
  EXPECT_EQ(masing_damping(mkz, 0.0), 0.0);
  // MKZ with s -> 1 is the hyperbola: quadrature against the closed form.
  const Backbone nearly = {60e6, gamma_r, 1.0, 1.0 - 1e-13};
  for (const double x : {1e-6, 0.049, 0.051, 1.0, 1e3, 1e6}) {
    EXPECT_NEAR(masing_damping(nearly, x * gamma_r) / masing_damping(hyperbola, x * gamma_r), 1.0, 1e-10)
        << "x = " << x;
  }
}

} // namespace
} // namespace tremolo::materials
