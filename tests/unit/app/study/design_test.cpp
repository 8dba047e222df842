#include "app/study/design.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace tremolo::app {
namespace {

scene::Axis array(const std::string& key, const std::vector<std::string>& values) {
  scene::Axis axis{.key = key};
  for (const std::string& value : values)
    axis.values.push_back({value, value, {}});
  return axis;
}

scene::Axis range(double low, double high, scene::RangeScale scale) {
  return {.key = "k", .range = scene::AxisRange{low, high, scale}};
}

scene::Study study(scene::SweepDesign design, int samples = 0) {
  scene::Study made;
  made.design = design;
  made.samples = samples;
  return made;
}

std::vector<std::string> texts(const Combination& values) {
  std::vector<std::string> all;
  for (const auto& value : values)
    all.push_back(value.toml);
  return all;
}

TEST(Design, TheLastAxisOfAProductTurnsFastest) {
  const auto all = combinations(study(scene::SweepDesign::product),
                                {array("a", {"1", "2"}), array("b", {"x"}), array("c", {"3", "4"})});
  ASSERT_EQ(4U, all.size());
  EXPECT_EQ((std::vector<std::string>{"1", "x", "3"}), texts(all[0]));
  EXPECT_EQ((std::vector<std::string>{"1", "x", "4"}), texts(all[1]));
  EXPECT_EQ((std::vector<std::string>{"2", "x", "3"}), texts(all[2]));
}

TEST(Design, AListTakesValuesTogetherAndRepeatsSingleOnes) {
  const auto all = combinations(study(scene::SweepDesign::list), {array("a", {"1", "2"}), array("b", {"x"})});
  ASSERT_EQ(2U, all.size());
  EXPECT_EQ((std::vector<std::string>{"1", "x"}), texts(all[0]));
  EXPECT_EQ((std::vector<std::string>{"2", "x"}), texts(all[1]));
}

TEST(Design, ALatinHypercubeHasOnePointInEachPartOfEachAxis) {
  constexpr std::size_t samples = 50;
  const auto points = latin_hypercube(samples, 4, 7);
  ASSERT_EQ(samples, points.size());
  for (std::size_t d = 0; d < 4; ++d) {
    std::set<std::size_t> parts;
    for (const auto& point : points) {
      ASSERT_GE(point[d], 0.0);
      ASSERT_LT(point[d], 1.0);
      parts.insert(static_cast<std::size_t>(point[d] * samples));
    }
    EXPECT_EQ(samples, parts.size());
  }
}

TEST(Design, AxesOfALatinHypercubeAreShuffledApart) {
  constexpr std::size_t samples = 400;
  const auto points = latin_hypercube(samples, 2, 1);
  double correlation = 0.0;
  for (const auto& point : points)
    correlation += 12.0 * (point[0] - 0.5) * (point[1] - 0.5) / samples;
  EXPECT_LT(std::abs(correlation), 4.0 / std::sqrt(samples)); // four standard deviations of independent axes
}

TEST(Design, TheSeedDecides) {
  EXPECT_EQ(latin_hypercube(20, 3, 5), latin_hypercube(20, 3, 5));
  EXPECT_NE(latin_hypercube(20, 3, 5), latin_hypercube(20, 3, 6));
}

TEST(Design, RangesAreEvenOnTheirScaleAndArraysAreTakenAlikeOften) {
  const auto all =
      combinations(study(scene::SweepDesign::latin_hypercube, 8),
                   {range(10.0, 50.0, scene::RangeScale::linear), range(1e-3, 10.0, scene::RangeScale::log),
                    array("a", {"u", "v", "w", "x"})});
  std::set<int> linear;
  std::set<int> log;
  std::map<std::string, int> taken;
  for (const auto& values : all) {
    linear.insert(static_cast<int>((std::stod(values[0].toml) - 10.0) / 5.0));
    log.insert(static_cast<int>((std::log10(std::stod(values[1].toml)) + 3.0) / 0.5));
    ++taken[values[2].toml];
  }
  EXPECT_EQ((std::set<int>{0, 1, 2, 3, 4, 5, 6, 7}), linear);
  EXPECT_EQ((std::set<int>{0, 1, 2, 3, 4, 5, 6, 7}), log);
  EXPECT_EQ((std::map<std::string, int>{{"u", 2}, {"v", 2}, {"w", 2}, {"x", 2}}), taken);
}

} // namespace
} // namespace tremolo::app
