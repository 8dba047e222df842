// A foundation in saturated soil whose weight grows at once: the water along its base is pressed smoothly,
// and none of it jets out at the corners.

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "tests/support/liquefied_tunnel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

class WetBase : public testing::TestWithParam<materials::Drainage> {};

TEST_P(WetBase, IsPressedSmoothlyAndLetsNoJetOut) {
  constexpr double h = 0.25, depth = 1.0, half = 3.0; // m
  Spec spec = saturated_flat_ground(18.0, 6.0, h, GetParam(), 2e7);
  spec.water->fluid.bulk_modulus = 2e8;
  spec.soils.front().damping_time = 1e-3;
  spec.sides = Sides::periodic;
  spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
  spec.structures = {structure(rectangle(-half, -depth, half, 3.0), 1500.0, 0.5)};
  StandingScene scene(spec);
  scene.domain.spec.gravity *= 1.2;
  double fastest = 0.0; // |w|, m/s
  while (scene.stepper.time() < 0.5) {
    scene.stepper.step();
    for (const Particles& set : scene.domain.sets)
      for (std::size_t k = 0; set.traits.flowing && k < set.size(); ++k)
        fastest = std::max(fastest, std::hypot(set.wx[k] - set.vx[k], set.wy[k] - set.vy[k]));
  }
  EXPECT_LT(fastest, 0.1);
  // Excess pressure of the cells along the middle two thirds of the base, against the mean of their
  // neighbours: towards its ends the pressure under a rigid base grows without bound.
  std::map<long, double> pressure; // by column of cells
  for (const Particles& set : scene.domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      if (set.y[k] < -depth && set.y[k] > -depth - h && std::abs(set.x[k]) < 2.0 / 3.0 * half)
        pressure[std::lround(std::floor(set.x[k] / h))] += 0.25 * excess_pressure(set, k);
  constexpr double cells = 16.0;
  ASSERT_EQ(pressure.size(), 16U);
  double mean = 0.0;
  double noise = 0.0;
  for (const auto& [column, p] : pressure) {
    mean += p / cells;
    if (pressure.contains(column - 1) && pressure.contains(column + 1))
      noise += std::pow(p - 0.5 * (pressure[column - 1] + pressure[column + 1]), 2) / (cells - 2.0) / 1.5;
  }
  EXPECT_GT(mean, 1e3);
  EXPECT_LT(std::sqrt(noise), 0.02 * mean);
  RecordProperty("pressure", std::to_string(mean));
  RecordProperty("noise", std::to_string(std::sqrt(noise) / mean));
  RecordProperty("fastest", std::to_string(fastest));
}

INSTANTIATE_TEST_SUITE_P(Soils, WetBase, testing::Values(materials::Drainage::coupled));
INSTANTIATE_TEST_SUITE_P(AcceptanceSoils, WetBase, testing::Values(materials::Drainage::undrained));

} // namespace
} // namespace tremolo::mpm_domain
