// Prandtl's strip footing as a rigid structure: it carries (2 + pi) c, whether its base is rough or smooth,
// and stands straight on symmetric ground.

#include "tests/support/structure_scene.hpp"
#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <ostream>

namespace tremolo::mpm_domain {
namespace {

using test_support::rectangle;

constexpr double cohesion = 20e3; // Pa

struct Punch {
  bool rough;
  double cell_size; ///< m

  friend void PrintTo(const Punch& punch, std::ostream* out) {
    *out << (punch.rough ? "rough" : "smooth") << ", cells of " << punch.cell_size << " m";
  }
};

/// A punch whose weight is a share of the limit load.
Spec punch_on_clay(const Punch& punch, double load) {
  constexpr double width = 4.0, side = 6.0, depth = 4.0;
  Spec spec;
  spec.box = {-0.5 * width - side, -depth, 0.5 * width + side, 0.0};
  spec.cell_size = punch.cell_size;
  spec.gravity = test::gravity;
  spec.soils = {{"clay", test::perfectly_plastic({500.0, 20e6, 0.3}, cohesion, 0.0)}};
  spec.regions = {{0, rectangle(spec.box.x_min, -depth, spec.box.x_max, 0.0)}};
  const double pressure = load * (2.0 + std::numbers::pi) * cohesion;
  spec.structures = {{.name = "punch",
                      .outline = rectangle(-0.5 * width, 0.0, 0.5 * width, 1.0),
                      .density = pressure / test::gravity,
                      .friction = {0.0},
                      .adhesion = {punch.rough ? 2.0 * cohesion : 0.0}}};
  spec.threads = 2;
  return spec;
}

/// Whether the punch comes to rest on bonds and then on contact.
bool carries(const Punch& punch, double load) {
  Domain domain(punch_on_clay(punch, load));
  try {
    return !relax_under_gravity(domain, {.residual = 1e-4, .max_time = 15.0}, [](long, double) {}).slipping;
  } catch (const std::runtime_error&) {
    return false;
  }
}

class PrandtlsPunch : public testing::TestWithParam<Punch> {};

TEST_P(PrandtlsPunch, CarriesTwoPlusPiTimesTheCohesion) {
  EXPECT_TRUE(carries(GetParam(), 0.95));
  EXPECT_FALSE(carries(GetParam(), 1.07));
}

INSTANTIATE_TEST_SUITE_P(Punches, PrandtlsPunch, testing::Values(Punch{true, 0.4}));
INSTANTIATE_TEST_SUITE_P(AcceptancePunches, PrandtlsPunch,
                         testing::Values(Punch{true, 0.25}, Punch{false, 0.25}, Punch{true, 0.2},
                                         Punch{false, 0.2}));

TEST(PrandtlsPunch, StandsStraightAndBearsWithItsWeight) {
  test_support::StandingScene scene(punch_on_clay({true, 0.25}, 0.5));
  scene.run(0.2);
  const BodyForces forces = scene.domain.contact.forces(0);
  const double weight = -forces.weight.force.y;
  EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, weight, 5e-3 * weight);
  EXPECT_LT(std::abs(forces.normal.force.x + forces.friction.force.x), 1e-3 * weight);
  EXPECT_LT(std::abs(scene.body().tilt()), 1e-6);
}

} // namespace
} // namespace tremolo::mpm_domain
