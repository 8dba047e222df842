#include "mpm_domain/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tremolo::mpm_domain {
namespace {

/// The hat function averaged over the particle's box by quadrature: the definition of S, written without its
/// formula.
double averaged_hat(double node, double x, const Axis& axis) {
  constexpr int n = 20000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double s = x - axis.half_size + 2.0 * axis.half_size * (i + 0.5) / n;
    sum += std::max(0.0, 1.0 - std::abs(s - node) / axis.h);
  }
  return sum / n;
}

class Kernel : public testing::TestWithParam<double> {
protected:
  Axis axis_{-3.0, 0.5, 0.5 * GetParam()};
};

TEST_P(Kernel, WeightsAreTheAveragedHatFunctions) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (int i = 0; i < 20; ++i) {
    const double x = place(random);
    for (const Weights& w : {gimp_weights(x, axis_), cell_weights(x, axis_)})
      for (int a = 0; a < 4; ++a)
        EXPECT_NEAR(w.s[a], averaged_hat(axis_.origin + (w.base + a) * axis_.h, x, axis_), 1e-8);
  }
}

TEST_P(Kernel, ReproducesLinearFieldsAndTheirGradient) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const double x = place(random);
    for (const Weights& w : {gimp_weights(x, axis_), cell_weights(x, axis_)}) {
      const Lanes d = axis_.origin + axis_.h * (w.base + Lanes{0.0, 1.0, 2.0, 3.0}) - x;
      EXPECT_NEAR(sum(w.s), 1.0, 1e-14);
      EXPECT_NEAR(sum(w.s * d), 0.0, 1e-14);
      EXPECT_NEAR(sum(w.g), 0.0, 1e-13);
      EXPECT_NEAR(sum(w.g * d), 1.0, 1e-13);
      EXPECT_GE(std::min({w.s[0], w.s[1], w.s[2], w.s[3]}), -1e-15);
    }
    EXPECT_EQ(gimp_weights(x, axis_).s[3], 0.0);
  }
}

/// A box that has nearly left its first node, by 1e-9 and 1e-12 cells, leaves a weight of the square of that.
TEST_P(Kernel, NothingCancelsWhereABoxLeavesANode) {
  for (const double reach : {1e-9, 1e-12}) {
    const double xi = 1.0 + axis_.l - reach;
    const double exact = 1.0 + axis_.l - xi; // as far as xi can tell
    const RowWeights<double> w(xi, axis_);
    EXPECT_NEAR(w.s[0] / (exact * exact / (4.0 * axis_.l)), 1.0, 1e-2);
    EXPECT_NEAR(w.g[0] / (-exact / (2.0 * axis_.half_size)), 1.0, 1e-3);
  }
}

TEST_P(Kernel, SecondMomentIsThatOfTheWeights) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  const auto moment = [&](const auto& s, double first, double xi) {
    double m = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i)
      m += s[i] * std::pow(axis_.h * (first + static_cast<double>(i) - xi), 2);
    return m;
  };
  for (int i = 0; i < 200; ++i) {
    const double xi = place(random);
    const CellWeights<double> cell(xi, axis_);
    EXPECT_NEAR(cell.second_moment, moment(cell.s, -1.0, xi), 1e-15);
    EXPECT_GE(cell.second_moment, axis_.half_size * axis_.half_size / 3.0 - 1e-15);
    const RowWeights<double> row(xi + axis_.l, axis_);
    EXPECT_NEAR(row.second_moment, moment(row.s, 0.0, xi + axis_.l), 1e-15);
  }
}

TEST_P(Kernel, FourParticlesAtOnceAreFourParticles) {
  const Lanes xi = {0.0, 0.2, 0.6, 0.95};
  const CellWeights<Lanes> cell(xi, axis_);
  const RowWeights<Lanes> row(xi + axis_.l, axis_);
  for (int k = 0; k < 4; ++k) {
    const CellWeights<double> one(xi[k], axis_);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(cell.s[i][k], one.s[i], 1e-15);
      EXPECT_NEAR(cell.g[i][k], one.g[i], 1e-14);
    }
    const RowWeights<double> one_row(xi[k] + axis_.l, axis_);
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(row.s[j][k], one_row.s[j], 1e-15);
  }
}

TEST_P(Kernel, GradientIsTheDerivativeOfTheWeight) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  const double step = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const double x = place(random);
    const Weights w = gimp_weights(x, axis_);
    const Weights left = gimp_weights(x - step, axis_);
    const Weights right = gimp_weights(x + step, axis_);
    if (left.base != right.base)
      continue;
    for (int a = 0; a < 4; ++a)
      EXPECT_NEAR(w.g[a], (right.s[a] - left.s[a]) / (2.0 * step), 1e-5);
  }
}

// One to four particles per cell: half size h/2 ... h/8.
INSTANTIATE_TEST_SUITE_P(ParticleSizes, Kernel, testing::Values(0.5, 0.25, 0.5 / 3.0, 0.125));

} // namespace
} // namespace tremolo::mpm_domain
