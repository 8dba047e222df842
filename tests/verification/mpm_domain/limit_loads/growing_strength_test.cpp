// A rough strip footing on clay whose strength grows with depth, c = c_0 + rho z, in slices as high as the
// cells, as the scene cuts soils over depth. Its load is that of slip lines, which for a smooth footing are
// compared with published values first.

#include "tests/verification/mpm_domain/limit_loads/footing.hpp"
#include "tests/verification/mpm_domain/limit_loads/slip_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <ostream>

namespace tremolo::mpm_domain {
namespace {

/// rho = 0 is Prandtl's footing. rho B = 4 c_0: PLAXIS 2D, Validation Manual, version 8, section 3.2, after
/// Davis and Booker (1973): F [(2 + pi) c_0 + rho B / 4] = 7.80 c_0.
TEST(SlipLines, GiveThePublishedLoads) {
  constexpr double prandtl = 2.0 + std::numbers::pi;
  EXPECT_NEAR(test::SlipLines(1.0, 0.0, 2.0).smooth(), prandtl, 1e-3 * prandtl);
  EXPECT_NEAR(test::SlipLines(1.0, 0.0, 2.0).rough(), prandtl, 1e-3 * prandtl);
  EXPECT_NEAR(test::SlipLines(1.0, 2.0, 2.0).smooth(), 7.80, 3e-3 * 7.80);
}

struct Ground {
  double cell_size; ///< m
  double poisson;
  double fails_at = 1.05; ///< over the load of slip lines

  friend void PrintTo(const Ground& g, std::ostream* out) {
    *out << "cells of " << g.cell_size << " m, nu " << g.poisson;
  }
};

constexpr double surface_strength = 20e3; // Pa
constexpr double growth = 5e3;            // Pa/m: rho B = c_0

/// @param load  over that of slip lines
bool carries(const Ground& ground, double load) {
  static const double limit = test::SlipLines(surface_strength, growth, test::footing_width).rough();
  Spec spec = test::footing_on_clay(ground.cell_size, load * limit, 2e8);
  const auto slices = static_cast<std::size_t>(std::lround(test::clay_depth / ground.cell_size));
  const Soil block = spec.soils.back();
  spec.soils.clear();
  for (std::size_t i = 0; i < slices; ++i) {
    const double z = (static_cast<double>(i) + 0.5) * ground.cell_size;
    spec.soils.push_back({"clay", test::light_clay(ground.poisson, surface_strength + growth * z)});
    if (i > 0)
      spec.regions.front().cuts.push_back(-static_cast<double>(i) * ground.cell_size);
  }
  spec.soils.push_back(block);
  spec.regions.back().soil = slices;
  return test::carries_its_weight(spec, 15.0);
}

class DavisAndBooker : public testing::TestWithParam<Ground> {};

TEST_P(DavisAndBooker, RoughFootingCarriesTheLoadOfSlipLines) {
  EXPECT_TRUE(carries(GetParam(), 0.95));
  EXPECT_FALSE(carries(GetParam(), GetParam().fails_at));
}

// The footing asks for finer cells than Prandtl's: on 16 it carries 5 to 10 % too much.
INSTANTIATE_TEST_SUITE_P(Meshes, DavisAndBooker,
                         testing::Values(Ground{0.25, 0.3, 1.10}, Ground{0.2, 0.3}, Ground{1.0 / 6.0, 0.3},
                                         Ground{0.2, 0.495}));

} // namespace
} // namespace tremolo::mpm_domain
