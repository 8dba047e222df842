// A rigid block stands while the resultant of its weight and its inertia goes through its base, and topples
// where it goes beside it, wherever its corners lie between nodes: a leaning one, and a straight one that is
// shaken, at a/g = B/H.

#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <span>
#include <string>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::rectangle;
using test_support::StandingScene;
using test_support::structure;

constexpr double width = 1.0, height = 2.0; // B, H, m
const materials::Elasticity rock{2000.0, 2e9, 0.2};

struct Base {
  int cells;     ///< across
  double offset; ///< of its corners from nodes, cells

  double cell_size() const { return width / cells; }
  friend void PrintTo(const Base& base, std::ostream* out) {
    *out << base.cells << " cells, corners " << base.offset << " cells beside nodes";
  }
};

class LeaningBlock : public testing::TestWithParam<Base> {};

/// Tilt after 0.6 s of a block whose centre of mass is aside of the middle of its base by a share of half its
/// width, over that at which a straight one of its width and height overturns.
double tilt_of_leaning(const Base& base, double share) {
  Spec spec = flat_ground(6.0, 1.5, base.cell_size(), rock);
  const double left = -0.5 * width + base.offset * base.cell_size();
  const double right = left + width;
  const double lean = share * width; // of the top
  spec.structures = {
      structure({{left, 0.0}, {right, 0.0}, {right - lean, height}, {left - lean, height}}, 2000.0, 1.0)};
  StandingScene scene(spec);
  scene.run(0.6);
  return scene.body().tilt() / std::atan2(width, height);
}

TEST_P(LeaningBlock, TopplesWhereItsCentreOfMassLeavesItsBase) {
  const double stands = tilt_of_leaning(GetParam(), 0.97);
  const double topples = tilt_of_leaning(GetParam(), 1.03);
  EXPECT_LT(std::abs(stands), 0.01);
  EXPECT_GT(topples, 0.03);
  RecordProperty("tilt_at_0.97", std::to_string(stands));
  RecordProperty("tilt_at_1.03", std::to_string(topples));
}

INSTANTIATE_TEST_SUITE_P(Bases, LeaningBlock,
                         testing::Values(Base{4, 0.0}, Base{4, 0.3}, Base{4, 0.5}, Base{4, 0.7}));
INSTANTIATE_TEST_SUITE_P(AcceptanceBases, LeaningBlock,
                         testing::Values(Base{8, 0.0}, Base{8, 0.3}, Base{8, 0.5}, Base{8, 0.7}));

/// Likewise after 1.2 s of a straight block on ground that takes up an acceleration within 0.2 s, by that
/// acceleration over g B/H.
double tilt_of_shaken(const Base& base, double share) {
  constexpr double gravity = 9.81, rise = 0.2; // m/s2, s
  Spec spec = flat_ground(6.0, 1.5, base.cell_size(), rock);
  const double left = -0.5 * width + base.offset * base.cell_size();
  spec.structures = {structure(rectangle(left, 0.0, left + width, height), 2000.0, 2.0)};
  StandingScene scene(spec, [&](long, double t, std::span<const Vector>, std::span<eq6::FreeField> field) {
    const double duration = t < rise ? 0.5 * std::max(0.0, t) * t / rise : t - 0.5 * rise;
    for (eq6::FreeField& face : field)
      face = {{share * gravity * width / height * duration, 0.0}, {}};
  });
  scene.run(1.2);
  return scene.body().tilt() / std::atan2(width, height);
}

TEST(ShakenBlock, TopplesWhereItsAccelerationExceedsWidthOverHeight) {
  constexpr Base base{4, 0.4};
  const double stands = tilt_of_shaken(base, 0.97);
  const double topples = tilt_of_shaken(base, 1.03);
  EXPECT_LT(std::abs(stands), 0.03);
  EXPECT_GT(std::abs(topples), 0.15);
  RecordProperty("tilt_at_0.97", std::to_string(stands));
  RecordProperty("tilt_at_1.03", std::to_string(topples));
}

} // namespace
} // namespace tremolo::mpm_domain
