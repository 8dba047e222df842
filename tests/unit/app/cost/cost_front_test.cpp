// Pareto front, fits and the answer to a wanted error, on tables whose answers are known.

#include "app/cost/cost_front.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace tremolo::app;
using ::testing::ElementsAre;

TEST(CostFront, HoldsWhatNoOtherRungBeatsInBoth) {
  const std::vector<CostPoint> points{{.error = 0.10, .cpu = 1.0},  {.error = 0.03, .cpu = 4.0},
                                      {.error = 0.05, .cpu = 4.5},  {.error = 0.20, .cpu = 0.5},
                                      {.error = 0.01, .cpu = 16.0}, {.error = 0.10, .cpu = 1.5},
                                      {.error = 0.03, .cpu = 5.0},  {.error = 0.02, .cpu = 16.0}};
  EXPECT_THAT(pareto_front(points), ElementsAre(3, 0, 1, 4));
}

TEST(CostFront, OfNothingIsEmpty) {
  EXPECT_TRUE(pareto_front({}).empty());
}

/// e = 0.03 h^2, u = 1e6 h^-3, t = 0.2 s + 80 ns u.
CostPoint exact_point(double size, double factor = 1.0) {
  const double work = 1e6 * std::pow(size, -3.0);
  return {"apic", size, factor * 0.03 * size * size, 0.2 + 80e-9 * work, work};
}

TEST(CostFit, FindsTheLawsOfItsPoints) {
  const std::vector<CostPoint> points{exact_point(2.0), exact_point(1.0), exact_point(0.5)};
  const auto found = fits(points);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].order, 2.0, 1e-12);
  EXPECT_NEAR(found[0].constant, 0.03, 1e-12);
  EXPECT_NEAR(found[0].work_order, 3.0, 1e-12);
  EXPECT_NEAR(found[0].start, 0.2, 1e-9);
  EXPECT_NEAR(found[0].per_update, 80e-9, 1e-15);
  EXPECT_NEAR(found[0].error_spread, 1.0, 1e-9);
  EXPECT_NEAR(found[0].time_spread, 1.0, 1e-9);
  EXPECT_NEAR(found[0].cpu_at(0.25), exact_point(0.25).cpu, 1e-9);
  EXPECT_NEAR(*size_for(found[0], 0.01), std::sqrt(1.0 / 3.0), 1e-9);
}

TEST(CostFit, StatesHowFarItsPointsLieFromIt) {
  const std::vector<CostPoint> points{exact_point(2.0), exact_point(1.0, 1.331), exact_point(0.5)};
  // Of three equal steps the middle one keeps two thirds of its deviation, the others a third each.
  EXPECT_NEAR(fits(points)[0].error_spread, 1.21, 1e-9);
}

TEST(CostFit, TimeHasNoNegativeStart) {
  const std::vector<CostPoint> points{{"a", 2.0, 0.4, 1.0, 1e6}, {"a", 1.0, 0.1, 10.0, 8e6}};
  const auto found = fits(points);
  EXPECT_EQ(found[0].start, 0.0);
  EXPECT_GT(found[0].per_update, 1e-6);
  EXPECT_LT(found[0].per_update, 10.0 / 8e6);
}

TEST(CostFit, FamiliesAreFittedApartAndOneSizeIsNone) {
  std::vector<CostPoint> points{exact_point(2.0), exact_point(1.0)};
  points.push_back({"flip", 1.0, 0.2, 1.0, 1e6});
  points.push_back({"flip", 0.5, 0.1, 8.0, 8e6});
  points.push_back({"alone", 1.0, 0.2, 1.0, 1e6});
  const auto found = fits(points);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].family, "apic");
  EXPECT_EQ(found[1].family, "flip");
  EXPECT_NEAR(found[1].order, 1.0, 1e-12);
}

TEST(CostFit, IsNotAskedForWhatItCannotSee) {
  const std::vector<CostPoint> converging{exact_point(2.0), exact_point(1.0)};
  const CostFit fit = fits(converging)[0];
  EXPECT_NEAR(*size_for(fit, 0.03 / 16.0), 0.25, 1e-9);
  EXPECT_FALSE(size_for(fit, 0.03 / 17.0));
  EXPECT_NEAR(*size_for(fit, 0.9), 2.0, 1e-9); // not coarser than what was measured
  const std::vector<CostPoint> stuck{{"a", 2.0, 0.035, 1.0, 1e6}, {"a", 1.0, 0.030, 8.0, 8e6}};
  EXPECT_FALSE(size_for(fits(stuck)[0], 0.01));
}

} // namespace
