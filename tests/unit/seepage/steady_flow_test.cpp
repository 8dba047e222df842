#include "seepage/elements.hpp"
#include "tests/support/seepage_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::seepage {
namespace {

using test_support::SeepageBlock;

std::size_t column(const SeepageBlock& block, double x) {
  return static_cast<std::size_t>(std::lround(x / block.cell));
}

// q = (H1 - H2)/(L1/k1 + L2/k2): continuity, and the drops of both layers add up.
TEST(SteadyFlow, ThroughTwoLayersInSeriesDropsMostInTheTightOne) {
  SeepageBlock block(10.0, 1.0, 0.5, [](double x, double) { return x < 6.0 ? 1e-4 : 1e-5; });
  for (std::size_t j = 0; j <= block.rows; ++j) {
    block.give(block.node(0, j), 12.0);
    block.give(block.node(block.columns, j), 10.0);
  }
  const SteadyFlow flow = solve(block.problem);
  const double q = 2.0 / (6.0 / 1e-4 + 4.0 / 1e-5);
  EXPECT_NEAR(q, 4.3478e-6, 1e-10);
  EXPECT_NEAR(flow.discharge, q, 1e-6 * q);
  const double drop = flow.heads[block.node(column(block, 6.0), 0)] - 10.0;
  EXPECT_NEAR(drop, q * 4.0 / 1e-5, 1e-6 * 2.0);
  EXPECT_NEAR(drop, 1.7391, 1e-4);
}

// Upwards through the same layers, to a surface that is open to the air.
TEST(SteadyFlow, UpwardsLeavesAtTheSurface) {
  SeepageBlock block(1.0, 10.0, 0.5, [](double, double y) { return y < 6.0 ? 1e-4 : 1e-5; });
  for (std::size_t i = 0; i <= block.columns; ++i) {
    block.give(block.node(i, 0), 12.0);
    block.problem.conditions[block.node(i, block.rows)] = Condition::exit;
  }
  const SteadyFlow flow = solve(block.problem);
  EXPECT_NEAR(flow.discharge, 4.3478261e-6, 1e-6 * flow.discharge); // 1 m wide
  EXPECT_EQ(flow.exits.size(), block.columns + 1);
  const std::size_t tight = block.rows - 1;
  const Vector i = gradient(block.problem, block.problem.elements[tight * block.columns], flow.heads);
  EXPECT_NEAR(i.y, -0.43478261, 1e-6);
  EXPECT_NEAR(i.x, 0.0, 1e-9);
}

TEST(SteadyFlow, WaterAtRestRestsWhateverTheGround) {
  SeepageBlock block(4.0, 8.0, 0.5, [](double x, double y) { return 1e-5 * (1.0 + x + 3.0 * y); });
  block.stand_between(5.0, 5.0);
  const SteadyFlow flow = solve(block.problem);
  for (const double head : flow.heads)
    EXPECT_NEAR(head, 5.0, 1e-9);
  EXPECT_LT(flow.discharge, 1e-15);
  EXPECT_TRUE(flow.exits.empty());
}

// Dupuit's discharge is exact between vertical faces (Charny 1951, in Polubarinova-Kochina 1962, Theory of
// ground water movement). Surface and exit: a variational inequality on a grid of 0.025 m.
TEST(Dam, LetsCharnysDischargeThrough) {
  SeepageBlock dam(10.0, 10.0, 0.25, [](double, double) { return 1e-5; });
  dam.stand_between(8.0, 2.0);
  const SteadyFlow flow = solve(dam.problem);
  const double exact = 1e-5 * (64.0 - 4.0) / 20.0;
  EXPECT_NEAR(flow.discharge, exact, 0.01 * exact);
  constexpr std::array<std::array<double, 2>, 4> surface{
      {{2.5, 7.28}, {5.0, 6.27}, {7.5, 4.96}, {9.0, 3.92}}};
  for (const auto& [x, y] : surface)
    EXPECT_NEAR(dam.surface(flow, column(dam, x)), y, 0.03) << x;
  const auto exit = exit_point(dam.problem, flow);
  ASSERT_TRUE(exit);
  EXPECT_NEAR(exit->y, 2.76, 0.1);
  EXPECT_EQ(exit->x, 10.0);
  EXPECT_LE(flow.iterations, 60);
}

// What leaves above the tail water leaves under atmospheric pressure, and none enters there.
TEST(Dam, SeepsBelowItsExitAndIsSealedAbove) {
  SeepageBlock dam(10.0, 10.0, 0.5, [](double, double) { return 1e-5; });
  dam.stand_between(8.0, 2.0);
  const SteadyFlow flow = solve(dam.problem);
  for (std::size_t j = 0; j <= dam.rows; ++j) {
    const std::size_t n = dam.node(dam.columns, j);
    const double y = dam.problem.nodes[n].y;
    if (dam.problem.conditions[n] == Condition::exit && std::ranges::count(flow.exits, n) > 0) {
      EXPECT_EQ(flow.heads[n], y);
    } else if (dam.problem.conditions[n] == Condition::exit) {
      EXPECT_LT(flow.heads[n], y);
      EXPECT_LT(std::abs(flow.inflow[n]), 1e-5 * flow.discharge);
    }
  }
}

TEST(Dam, OfSixteenMetresHasTheExitOfTheLiterature) {
  SeepageBlock dam(16.0, 24.0, 0.5, [](double, double) { return 1e-5; });
  dam.stand_between(24.0, 4.0);
  const SteadyFlow flow = solve(dam.problem);
  EXPECT_NEAR(flow.discharge, 17.5e-5, 0.01 * 17.5e-5);
  EXPECT_NEAR(exit_point(dam.problem, flow)->y, 12.8, 0.3);
}

// A head that is linear in x and y flows through elements of any shape.
TEST(Elements, OfAnyShapeHoldALinearHead) {
  FlowProblem problem;
  problem.nodes = {{0.0, 0.0}, {1.0, 0.1}, {2.0, -0.1}, {0.1, 1.0}, {1.2, 1.3}, {2.1, 0.9}, {0.9, 2.0}};
  problem.elements = {
      {{0, 1, 4, 3}, 4, 2e-5}, {{1, 2, 5, 4}, 4, 2e-5}, {{3, 4, 6, 0}, 3, 2e-5}, {{4, 5, 6, 0}, 3, 2e-5}};
  problem.transition = 0.25;
  problem.conditions.assign(problem.nodes.size(), Condition::head);
  problem.conditions[4] = Condition::none;
  for (const Vector& place : problem.nodes)
    problem.given.push_back(20.0 + 0.3 * place.x - 0.7 * place.y);
  const SteadyFlow flow = solve(problem);
  EXPECT_NEAR(flow.heads[4], problem.given[4], 1e-9);
  for (const Element& element : problem.elements) {
    const Vector i = gradient(problem, element, flow.heads);
    EXPECT_NEAR(i.x, 0.3, 1e-9);
    EXPECT_NEAR(i.y, -0.7, 1e-9);
  }
}

TEST(Elements, LoseTheirPermeabilityAboveTheSurface) {
  EXPECT_EQ(relative_permeability(0.1, 0.25), 1.0);
  EXPECT_EQ(relative_permeability(0.0, 0.25), 1.0);
  EXPECT_NEAR(relative_permeability(-0.125, 0.25), 0.5005, 1e-12);
  EXPECT_NEAR(relative_permeability(-0.25, 0.25), 1e-3, 1e-12);
  EXPECT_EQ(relative_permeability(-5.0, 0.25), 1e-3);
}

TEST(SteadyFlow, RefusesWhatCannotBeSolved) {
  const auto sand = [](double, double) { return 1e-5; };
  SeepageBlock unknown(2.0, 2.0, 0.5, sand);
  EXPECT_THROW(solve(unknown.problem), std::invalid_argument);
  SeepageBlock sealed(2.0, 2.0, 0.5, [](double, double) { return 0.0; });
  sealed.stand_between(2.0, 1.0);
  EXPECT_THROW(solve(sealed.problem), std::invalid_argument);
  SeepageBlock empty(2.0, 2.0, 0.5, sand);
  empty.problem.elements.clear();
  EXPECT_THROW(solve(empty.problem), std::invalid_argument);
}

} // namespace
} // namespace tremolo::seepage
