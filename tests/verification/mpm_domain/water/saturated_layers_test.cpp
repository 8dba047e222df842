// Matched layers beside saturated ground: they take up what a blow in the ground sends out, with the
// undrained constants of grains and water together.

#include "tests/support/blow.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tremolo {
namespace {

struct Ground {
  double width = 40.0; ///< m
  double depth = 20.0;
  bool layers = false;
};

/// Saturated ground of soft pore water (c_u 390 m/s, not 1,700), so that a box that nothing comes back from
/// is small.
mpm_domain::Spec saturated_box(const Ground& ground) {
  mpm_domain::Spec spec = test_support::elastic_box(ground.width, ground.depth, 1.0);
  spec.threads = 1;
  spec.scheme.dt = 5e-4;
  const materials::PoreFluid fluid{.bulk_modulus = 1e8};
  // Drag goes with g/k: nothing has weight, and water moves with the grains.
  spec.gravity = 1e-6;
  const materials::PoreSpace pores{.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-11};
  spec.water = {0.0, fluid};
  spec.soils.front().pores = pores;
  spec.soils.front().law = materials::LinearElastic{{materials::saturated_density(pores, fluid), 40e6, 0.28}};
  if (ground.layers)
    spec.matched_sides = {mpm_domain::Side::left, mpm_domain::Side::right, mpm_domain::Side::base};
  return spec;
}

std::vector<double> after_a_blow(const Ground& ground) {
  return test_support::seen_after_a_blow(saturated_box(ground), 0.2);
}

// Nothing comes back from the wide box within 0.2 s: its P waves have 78 m to go.
TEST(SaturatedLayers, TakeUpABlowInTheGround) {
  const std::vector<double> wide = after_a_blow({.width = 100.0, .depth = 50.0});
  const double dashpots = test_support::relative_difference(after_a_blow({}), wide);
  const double layers = test_support::relative_difference(after_a_blow({.layers = true}), wide);
  RecordProperty("dashpots", std::to_string(dashpots));
  RecordProperty("layers", std::to_string(layers));
  EXPECT_LT(layers, 0.3 * dashpots) << dashpots;
}

} // namespace
} // namespace tremolo
