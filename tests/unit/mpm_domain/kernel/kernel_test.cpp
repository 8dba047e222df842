#include "mpm_domain/kernel/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// The integral of the hat function of node 0 from -1 to t cells.
double integrated_hat(double t) {
  const double inside = std::clamp(t, -1.0, 1.0);
  return 0.5 + inside - 0.5 * inside * std::abs(inside);
}

/// The hat function averaged over the particle's box: the definition of S, written without its formula.
double averaged_hat(double node, double x, const Axis& axis, double half_side) {
  const double low = (x - half_side - node) / axis.h;
  const double high = (x + half_side - node) / axis.h;
  return (integrated_hat(high) - integrated_hat(low)) / (high - low);
}

class Kernel : public testing::TestWithParam<double> {
protected:
  /// Weights by every kernel that holds a box of this size.
  std::vector<Weights> all_weights(double x) const {
    std::vector<Weights> all{cell_weights(x, axis_, half_side_)};
    if (GetParam() <= 0.5)
      all.push_back(gimp_weights(x, axis_, half_side_));
    return all;
  }

  Axis axis_{-3.0, 0.5};
  double half_side_ = 0.5 * GetParam();
  HalfSide<double> box_{half_side_, axis_};
};

TEST_P(Kernel, WeightsAreTheAveragedHatFunctions) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> position(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const double x = position(random);
    for (const Weights& w : all_weights(x))
      for (int a = 0; a < 4; ++a)
        EXPECT_NEAR(w.s[a], averaged_hat(axis_.origin + (w.base + a) * axis_.h, x, axis_, half_side_),
                    1e-14 / GetParam());
  }
}

TEST_P(Kernel, ReproducesLinearFieldsAndTheirGradient) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> position(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const double x = position(random);
    for (const Weights& w : all_weights(x)) {
      const Lanes d = axis_.origin + axis_.h * (w.base + Lanes{0.0, 1.0, 2.0, 3.0}) - x;
      EXPECT_NEAR(sum(w.s), 1.0, 1e-14);
      EXPECT_NEAR(sum(w.s * d), 0.0, 1e-14);
      EXPECT_NEAR(sum(w.g), 0.0, 1e-13);
      EXPECT_NEAR(sum(w.g * d), 1.0, 1e-13);
      EXPECT_GE(std::min({w.s[0], w.s[1], w.s[2], w.s[3]}), -1e-15);
    }
  }
}

/// A box that has nearly left its first node, by 1e-9 and 1e-12 cells, leaves a weight of the square of that.
TEST_P(Kernel, NothingCancelsWhereABoxLeavesANode) {
  for (const double reach : {1e-9, 1e-12}) {
    if (GetParam() > 0.5)
      continue;
    const double xi = 1.0 + box_.l - reach;
    const double exact = 1.0 + box_.l - xi; // as far as xi can tell
    const RowWeights<double> w(xi, axis_, box_);
    EXPECT_NEAR(w.s[0] / (exact * exact / (4.0 * box_.l)), 1.0, 1e-2);
    EXPECT_NEAR(w.g[0] / (-exact / (2.0 * half_side_)), 1.0, 1e-3);
  }
}

TEST_P(Kernel, SecondMomentIsThatOfTheWeights) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> position(0.0, 1.0);
  const auto moment = [&](const auto& s, double first, double xi) {
    double m = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i)
      m += s[i] * std::pow(axis_.h * (first + static_cast<double>(i) - xi), 2);
    return m;
  };
  for (int i = 0; i < 200; ++i) {
    const double xi = position(random);
    const CellWeights<double> cell(xi, axis_, box_);
    EXPECT_NEAR(cell.second_moment, moment(cell.s, -1.0, xi), 1e-15);
    EXPECT_GE(cell.second_moment, half_side_ * half_side_ / 3.0 - 1e-15);
    if (GetParam() > 0.5)
      continue;
    const RowWeights<double> row(xi + box_.l, axis_, box_);
    EXPECT_NEAR(row.second_moment, moment(row.s, 0.0, xi + box_.l), 1e-15);
  }
}

TEST_P(Kernel, FourParticlesAtOnceAreFourParticles) {
  const Lanes xi = {0.0, 0.2, 0.6, 0.95};
  const CellWeights<Lanes> cell(xi, axis_, box_);
  const RowWeights<Lanes> row(xi + box_.l, axis_, box_);
  for (int k = 0; k < 4; ++k) {
    const CellWeights<double> one(xi[k], axis_, box_);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(cell.s[i][k], one.s[i], 1e-15);
      EXPECT_NEAR(cell.g[i][k], one.g[i], 1e-14);
    }
    const RowWeights<double> one_row(xi[k] + box_.l, axis_, box_);
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_NEAR(row.s[j][k], one_row.s[j], 1e-15);
  }
}

TEST_P(Kernel, FourBoxesAtOnceAreFourBoxes) {
  const Lanes xi = {0.0, 0.2, 0.6, 0.95};
  const Lanes half_sides = half_side_ * Lanes{1.0, 0.7, 0.4, 0.1};
  const CellWeights<Lanes> cell(xi, axis_, HalfSide<Lanes>(half_sides, axis_));
  for (int k = 0; k < 4; ++k) {
    const CellWeights<double> one(xi[k], axis_, HalfSide<double>(half_sides[k], axis_));
    EXPECT_NEAR(cell.second_moment[k], one.second_moment, 1e-15);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(cell.s[i][k], one.s[i], 1e-15);
      EXPECT_NEAR(cell.g[i][k], one.g[i], 1e-14);
    }
  }
}

TEST_P(Kernel, GradientIsTheDerivativeOfTheWeight) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> position(-1.0, 1.0);
  const double step = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const double x = position(random);
    const Weights w = cell_weights(x, axis_, half_side_);
    const Weights left = cell_weights(x - step, axis_, half_side_);
    const Weights right = cell_weights(x + step, axis_, half_side_);
    if (left.base != right.base)
      continue;
    for (int a = 0; a < 4; ++a)
      EXPECT_NEAR(w.g[a], (right.s[a] - left.s[a]) / (2.0 * step), 1e-5);
  }
}

// Half sides over h: of one to four particles per cell at the start, and of boxes that have followed the
// soil.
INSTANTIATE_TEST_SUITE_P(BoxSizes, Kernel,
                         testing::Values(0.5, 0.25, 0.5 / 3.0, 0.125, 0.03, 0.37, 0.8, 1.0));

} // namespace
} // namespace tremolo::mpm_domain
