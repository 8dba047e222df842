// Impulses at segments against the conditions that define them.

#include "mpm_domain/lining/segment_contact.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Segments that answer to each other, and speeds at which they close.
struct Problem {
  Matrix answer;
  Eigen::VectorXd closing;
  std::vector<SegmentContact> segments;

  int solve(bool bonded = false) {
    return solve_segments({answer.data(), static_cast<std::size_t>(answer.size())},
                          {closing.data(), static_cast<std::size_t>(closing.size())}, segments, bonded);
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
