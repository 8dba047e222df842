// Springs beside the dashpots return no more of the waves that a canyon and a heavy block scatter than
// dashpots alone, before a box from whose boundaries nothing comes back in time.

#include "tests/support/scattering_run.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tremolo {
namespace {

using namespace test_support;

struct Errors {
  double dashpots = 0.0;
  double springs = 0.0; ///< a = 1
};

/// Relative L2 errors of the velocity around the scatterer in boxes of the given width (m), 20 m deep.
Errors errors(ScatteringRun run, double width, const ScatteredMotion& reference) {
  run.width = width;
  run.absorber = Absorber::dashpots;
  const double dashpots = difference(shake(run), reference);
  run.absorber = Absorber::springs;
  return {dashpots, difference(shake(run), reference)};
}

ScatteredMotion in_wide_ground(ScatteringRun run, double width) {
  run.width = width;
  run.absorber = Absorber::layer_below;
  run.layer_cells = 100;
  return shake(run);
}

void compare(const ScatteringRun& run, double width, const ScatteredMotion& reference) {
  const auto [dashpots, springs] = errors(run, width, reference);
  testing::Test::RecordProperty("dashpots_" + std::to_string(width), std::to_string(dashpots));
  testing::Test::RecordProperty("springs_" + std::to_string(width), std::to_string(springs));
  EXPECT_LT(springs, dashpots) << width << " m";
  EXPECT_LT(dashpots, 0.5) << width << " m";
  EXPECT_GT(springs, 1e-3) << width << " m";
}

TEST(SpringsUnderScatteredWaves, ReturnNoMoreOfACanyonThanDashpots) {
  const ScatteringRun run{.field = BaseField::across, .angle_deg = 15.0, .scatterer = Scatterer::canyon};
  compare(run, 80.0, in_wide_ground(run, 640.0));
}

class Scatterers : public testing::TestWithParam<std::tuple<Scatterer, double>> {};

TEST_P(Scatterers, AcceptanceSpringsReturnNoMoreThanDashpots) {
  const auto [scatterer, angle] = GetParam();
  const ScatteringRun run{
      .field = BaseField::across, .angle_deg = angle, .scatterer = scatterer, .cell = 1.0};
  const ScatteredMotion reference = in_wide_ground(run, 1200.0);
  for (const double width : {40.0, 80.0, 160.0})
    compare(run, width, reference);
}

std::string scatterer_and_angle(const testing::TestParamInfo<std::tuple<Scatterer, double>>& test) {
  const auto& [scatterer, angle] = test.param;
  return (scatterer == Scatterer::canyon ? "Canyon" : "Block") + std::to_string(static_cast<int>(angle));
}

INSTANTIATE_TEST_SUITE_P(Angles, Scatterers,
                         testing::Combine(testing::Values(Scatterer::canyon, Scatterer::block),
                                          testing::Values(0.0, 15.0)),
                         scatterer_and_angle);

} // namespace
} // namespace tremolo
