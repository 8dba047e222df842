// A block that slides away over elastic ground leaves its weight at another place: springs beside the
// dashpots hold the box, and the block tilts as in a box twice as deep. Dashpots alone let the box turn for
// ever.

#include "tests/support/box_models.hpp"
#include "tests/support/structure_scene.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;

/// Tilt (degrees) of a block that has been pushed, and how far it has slid, m.
struct Tilt {
  double at_20_s = 0.0;
  double at_40_s = 0.0;
  double slid = 0.0;
};

/// A block of 98 kPa, 6 m wide, is given a velocity at which friction stops it after some 2.7 m.
/// @param across  a_n; 0: dashpots alone
Tilt tilt_after_sliding(double across, double depth) {
  mpm_domain::Spec spec;
  spec.box = {-24.0, -depth, 24.0, 0.0};
  spec.cell_size = 1.0;
  spec.gravity = 9.81;
  spec.soils = {{"ground", materials::LinearElastic{{1800.0, 25e6, 0.3}}}};
  spec.regions = {{0, rectangle(-24.0, -depth, 24.0, 0.0)}};
  spec.structures = {structure(rectangle(-3.0, 0.0, 3.0, 4.0), 2500.0, 0.3)};
  spec.scheme.fraction = 0.8;
  spec.threads = 1;
  if (across > 0.0)
    add_springs(spec, across, 0.5 * across, {0.0, 0.0});
  mpm_domain::Domain domain(spec);
  mpm_domain::replace_constraints(domain, mpm_domain::relax_under_gravity(domain, {}, [](long, double) {}));
  const auto& block = domain.contact.bodies().front();
  const double start = block.centre().x;
  const double push = std::sqrt(2.0 * 0.3 * spec.gravity * 2.7);
  set_motion(domain, 0, {{push, 0.0}, 0.0});
  mpm_domain::Stepper stepper(domain, 0.0, quiet_ground());
  Tilt tilt;
  while (stepper.time() < 40.0) {
    stepper.step();
    const double degrees = block.tilt() * 180.0 / std::numbers::pi;
    (stepper.time() < 20.0 ? tilt.at_20_s : tilt.at_40_s) = degrees;
  }
  tilt.slid = block.centre().x - start;
  testing::Test::RecordProperty(fmt::format("a_{}_depth_{}", across, depth),
                                fmt::format("{:.4f} and {:.4f} degrees at 20 and 40 s, {:.3f} m",
                                            tilt.at_20_s, tilt.at_40_s, tilt.slid));
  return tilt;
}

TEST(SlidingBlock, AcceptanceTiltsOnSpringsAsInADeeperBox) {
  const Tilt held = tilt_after_sliding(1.0, 12.0);
  const Tilt stiffer = tilt_after_sliding(2.0, 12.0);
  const Tilt deeper = tilt_after_sliding(1.0, 24.0);
  EXPECT_NEAR(held.slid, 2.7, 0.3);
  EXPECT_NEAR(held.at_40_s, held.at_20_s, 0.002 * std::abs(held.at_20_s));
  EXPECT_NEAR(held.at_40_s, deeper.at_40_s, 0.08 * std::abs(deeper.at_40_s));
  EXPECT_NEAR(stiffer.at_40_s, deeper.at_40_s, 0.04 * std::abs(deeper.at_40_s));
  const Tilt turning = tilt_after_sliding(0.0, 12.0);
  EXPECT_GT(std::abs(turning.at_40_s), 1.5 * std::abs(held.at_40_s));
  EXPECT_GT(std::abs(turning.at_40_s - turning.at_20_s), 0.1 * std::abs(held.at_40_s));
}

} // namespace
} // namespace tremolo
