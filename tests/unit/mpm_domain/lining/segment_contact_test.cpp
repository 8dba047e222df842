// Impulses at segments against the conditions that define them.

#include "mpm_domain/lining/segment_contact.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Segments that answer to each other, and speeds at which they close; some may be wet.
struct Problem {
  Matrix answer;
  Eigen::VectorXd closing;
  std::vector<SegmentContact> segments;
  SegmentWater water = {};

  int solve(bool bonded = false) {
    return solve_segments({answer.data(), static_cast<std::size_t>(answer.size())},
                          {closing.data(), static_cast<std::size_t>(closing.size())}, segments, bonded,
                          water);
  }
  /// q of a segment by its definition.
  double borne(std::size_t segment) const {
    double q = water.alone[segment];
    for (std::size_t s = 0; s < segments.size(); ++s)
      q -= water.answer[2 * (segment * segments.size() + s)] * segments[s].normal_impulse +
           water.answer[2 * (segment * segments.size() + s) + 1] * segments[s].tangential_impulse;
    return q;
  }
  /// The speeds at which both still close under these impulses.
  Eigen::VectorXd left() const {
    Eigen::VectorXd impulses(closing.size());
    for (std::size_t s = 0; s < segments.size(); ++s) {
      impulses(static_cast<Eigen::Index>(2 * s)) = segments[s].normal_impulse;
      impulses(static_cast<Eigen::Index>(2 * s + 1)) = segments[s].tangential_impulse;
    }
    return closing - answer * impulses;
  }
};

Problem random_problem(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  std::normal_distribution<double> number;
  const auto size = static_cast<Eigen::Index>(2 * count);
  Matrix half(size, size);
  Problem problem{.answer = {}, .closing = Eigen::VectorXd(size), .segments = {}};
  for (double& entry : half.reshaped())
    entry = number(random);
  problem.answer = half * half.transpose() / static_cast<double>(size) + 2.0 * Matrix::Identity(size, size);
  for (double& speed : problem.closing)
    speed = number(random);
  for (std::size_t s = 0; s < count; ++s)
    problem.segments.push_back({.friction = 0.4});
  return problem;
}

TEST(SegmentContact, MeetsTheConditionsOfContact) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Problem problem = random_problem(seed, 12);
    problem.solve();
    const Eigen::VectorXd left = problem.left();
    for (std::size_t s = 0; s < problem.segments.size(); ++s) {
      const SegmentContact& segment = problem.segments[s];
      const double normal = left(static_cast<Eigen::Index>(2 * s));
      const double tangential = left(static_cast<Eigen::Index>(2 * s + 1));
      EXPECT_GE(segment.normal_impulse, 0.0);
      EXPECT_LE(normal, 1e-10);
      EXPECT_NEAR(normal * segment.normal_impulse, 0.0, 1e-10);
      const double bound = segment.normal_impulse > 0.0 ? segment.bound(segment.normal_impulse) : 0.0;
      EXPECT_LE(std::abs(segment.tangential_impulse), bound + 1e-10);
      if (segment.normal_impulse <= 0.0)
        continue;
      if (std::abs(segment.tangential_impulse) < bound - 1e-9) {
        EXPECT_NEAR(tangential, 0.0, 1e-10) << seed; // it sticks
      } else {
        EXPECT_GE(tangential * segment.tangential_impulse, -1e-10) << seed; // friction brakes
      }
    }
  }
}

/// Three of four segments are wet; their water may bear suction down to -0.2. It answers to impulses as it
/// does to a lining that takes a third of what closes: q = S^-1 (c_f - H A^-1 H^T j), with S twice the unit.
Problem random_wet_problem(unsigned seed, std::size_t count) {
  Problem problem = random_problem(seed, count);
  std::mt19937 random(seed + 1000);
  std::normal_distribution<double> number;
  problem.water.answer.assign(2 * count * count, 0.0);
  for (std::size_t s = 0; s < count; ++s) {
    const bool wet = s % 4 != 0;
    problem.water.wet.push_back(wet);
    problem.water.alone.push_back(wet ? 0.2 * number(random) : 0.0);
    for (std::size_t c = 0; wet && c < 2 * count; ++c)
      problem.water.answer[2 * s * count + c] =
          problem.answer(static_cast<Eigen::Index>(2 * s), static_cast<Eigen::Index>(c)) / 6.0;
    problem.segments[s].least_water = -0.2;
  }
  return problem;
}

TEST(SegmentContact, RubsByWhatWaterDoesNotBear) {
  int swept = 0; // suction that breaks lets some cases have no solution, or several
  int suction = 0;
  int without_effective = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    Problem problem = random_wet_problem(seed, 12);
    if (problem.solve() == 0) {
      ++swept;
      continue;
    }
    const Eigen::VectorXd left = problem.left();
    for (std::size_t s = 0; s < problem.segments.size(); ++s) {
      const SegmentContact& segment = problem.segments[s];
      const double water = problem.borne(s);
      EXPECT_NEAR(segment.water_impulse, water, 1e-12);
      if (!segment.tied) {
        EXPECT_EQ(segment.normal_impulse, 0.0);
        EXPECT_EQ(segment.tangential_impulse, 0.0);
        EXPECT_LE(left(static_cast<Eigen::Index>(2 * s)), 1e-10);
        continue;
      }
      EXPECT_NEAR(left(static_cast<Eigen::Index>(2 * s)), 0.0, 1e-10);
      EXPECT_TRUE(segment.normal_impulse >= 0.0 || (problem.water.wet[s] && water > segment.least_water));
      suction += segment.normal_impulse < 0.0 ? 1 : 0;
      const double bound = 0.4 * std::max(0.0, segment.normal_impulse - water);
      without_effective += bound == 0.0 ? 1 : 0;
      EXPECT_LE(std::abs(segment.tangential_impulse), bound + 1e-10);
      const double slip = left(static_cast<Eigen::Index>(2 * s + 1));
      if (std::abs(segment.tangential_impulse) < bound - 1e-9)
        EXPECT_NEAR(slip, 0.0, 1e-10) << seed;
      else
        EXPECT_GE(slip * segment.tangential_impulse, -1e-10) << seed;
    }
  }
  EXPECT_LE(swept, 8); // of 200
  EXPECT_GT(suction, 20);
  EXPECT_GT(without_effective, 20);
}

TEST(SegmentContact, HoldsAllWhereItIsBonded) {
  Problem problem = random_problem(3, 20);
  EXPECT_EQ(problem.solve(true), 1);
  EXPECT_NEAR(problem.left().cwiseAbs().maxCoeff(), 0.0, 1e-12);
}

TEST(SegmentContact, LetsOneSegmentStickSlipAndOpen) {
  Problem one{.answer = Matrix::Identity(2, 2) * 0.5, .closing = Eigen::Vector2d(1.0, 0.3), .segments = {{}}};
  one.segments.front().friction = 0.4;
  one.solve();
  EXPECT_DOUBLE_EQ(one.segments.front().normal_impulse, 2.0);
  EXPECT_DOUBLE_EQ(one.segments.front().tangential_impulse, 0.6); // below 0.8
  one.closing(1) = -0.5;
  one.solve();
  EXPECT_DOUBLE_EQ(one.segments.front().tangential_impulse, -0.8);
  EXPECT_EQ(one.segments.front().slip, -1);
  one.segments.front().adhesion = 0.15; // kg/s
  one.solve();
  EXPECT_DOUBLE_EQ(one.segments.front().tangential_impulse, -0.95);
  one.closing(0) = -0.1;
  one.solve();
  EXPECT_EQ(one.segments.front().normal_impulse, 0.0);
  EXPECT_EQ(one.segments.front().tangential_impulse, 0.0);
  EXPECT_FALSE(one.segments.front().tied);
}

} // namespace
} // namespace tremolo::mpm_domain
