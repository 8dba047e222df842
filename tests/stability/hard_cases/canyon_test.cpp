// A canyon in a small box: what it scatters runs into the lower corners, where the matched layers of the
// sides and of the base meet.

#include "tests/support/canyon_run.hpp"
#include "tests/support/hard_case.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace tremolo {
namespace {

using namespace test_support;

constexpr mpm_domain::Box small_box{-80.0, -64.0, 80.0, 0.0};

Seen wide_box(Canyon canyon) {
  canyon.width = 320.0;
  canyon.depth = 128.0;
  return run_canyon(canyon, small_box);
}

class HardCase36 : public testing::TestWithParam<double> {};

TEST_P(HardCase36, CanyonInASmallBox) {
  const Canyon canyon{.angle_deg = GetParam()};
  bounded(fmt::format("difference of all velocities to a box of four times the area, {} degrees", GetParam()),
          relative_difference(run_canyon(canyon, small_box), wide_box(canyon)), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Angles, HardCase36, testing::Values(0.0, 15.0),
                         [](const auto& test) { return std::to_string(static_cast<int>(test.param)); });

TEST(HardCase36, WhateverTheDepthOfTheLayer) {
  Canyon canyon{.angle_deg = 30.0};
  const Seen wide = wide_box(canyon);
  for (const int cells : {5, 10, 20}) {
    canyon.layer_cells = cells;
    bounded(fmt::format("difference to the wide box, 30 degrees, layers of {} cells", cells),
            relative_difference(run_canyon(canyon, small_box), wide), 0.015);
  }
  canyon.layers = false;
  breaks("dashpots", relative_difference(run_canyon(canyon, small_box), wide), 0.015);
}

} // namespace
} // namespace tremolo
