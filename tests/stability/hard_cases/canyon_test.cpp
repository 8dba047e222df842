// A canyon in a small box: what it scatters runs into the lower corners, where the matched layers of the
// sides and of the base meet.

#include "tests/support/canyon_run.hpp"
#include "tests/support/hard_case.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>

namespace tremolo {
namespace {

using namespace test_support;

constexpr mpm_domain::Box small_box{-80.0, -64.0, 80.0, 0.0};

Seen wide_box(Canyon canyon) {
  canyon.width = 320.0;
  canyon.depth = 128.0;
  return run_canyon(canyon, small_box);
}

struct Row {
  double angle_deg;
  double cell_size; ///< m

  friend void PrintTo(const Row& row, std::ostream* out) {
    *out << row.angle_deg << " degrees, cells of " << row.cell_size << " m";
  }
};

class HardCase36CanyonInASmallBox : public testing::TestWithParam<Row> {};

TEST_P(HardCase36CanyonInASmallBox, CanyonInASmallBox) {
  const Canyon canyon{.cell_size = GetParam().cell_size, .angle_deg = GetParam().angle_deg};
  bounded("difference of all velocities to a box of four times the area, " +
              testing::PrintToString(GetParam()),
          relative_difference(run_canyon(canyon, small_box), wide_box(canyon)), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Angles, HardCase36CanyonInASmallBox, testing::Values(Row{0.0, 1.6}));

INSTANTIATE_TEST_SUITE_P(AcceptanceAngles, HardCase36CanyonInASmallBox,
                         testing::Values(Row{0.0, 1.0}, Row{15.0, 1.0}));

TEST(HardCase36CanyonInASmallBox, AcceptanceWhateverTheDepthOfTheLayer) {
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

class HardCase36SpringsBesideDashpots : public testing::TestWithParam<double> {};

// They hold static forces, and what the canyon scatters comes back less.
TEST_P(HardCase36SpringsBesideDashpots, AcceptanceSendBackLessOfACanyon) {
  Canyon canyon{.angle_deg = GetParam()};
  const Seen wide = wide_box(canyon);
  canyon.layers = false;
  const double dashpots = relative_difference(run_canyon(canyon, small_box), wide);
  canyon.springs = true;
  const double springs = relative_difference(run_canyon(canyon, small_box), wide);
  bounded(fmt::format("difference to the wide box over that of dashpots alone, {} degrees", GetParam()),
          springs / dashpots, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Degrees, HardCase36SpringsBesideDashpots, testing::Values(0.0, 15.0));

/// Largest speed of any particle in the last 1.5 s of 3 s after the pulse, over that of the incident wave.
double late_speed(Canyon canyon) {
  canyon.cell_size = 4.0;
  canyon.angle_deg = 15.0;
  canyon.end = 3.0;
  double largest = 0.0;
  const Seen seen = run_canyon(canyon, small_box);
  for (std::size_t sample = seen.size() - 75; sample < seen.size(); ++sample)
    for (const eq6::Vector& v : seen[sample])
      largest = std::max(largest, std::hypot(v.x, v.y));
  return largest / canyon_wave(15.0).amplitude;
}

// A particle in a cell of its surface that is not full moves in a way that nodes hardly see, so hardly
// anything pulls it back. APIC forgets that motion, FLIP does not: it is refused there
// (flip_has_surface_along_grid.cpp).
TEST(HardCase37RingingSurface, NothingRingsAfterThePulse) {
  bounded("APIC, canyon", late_speed({}), 0.01);
  bounded("FLIP, notch along the grid", late_speed({.transfer = mpm_domain::Transfer::flip, .notch = true}),
          0.3);
  breaks("FLIP, canyon", late_speed({.transfer = mpm_domain::Transfer::flip}), 0.3);
}

} // namespace
} // namespace tremolo
