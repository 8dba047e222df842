// How far soil has moved through its dashpots, and when that is told.

#include "mpm_domain/boundary/drift/lost_hold.hpp"

#include "tests/support/box_run.hpp"
#include "tests/support/saved_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using ::testing::HasSubstr;

/// Free field and soil move with 3 m/s; the soil at the right side below y = -5 m by `slip` m/s more.
LostHold after(double seconds, const Domain& domain, double slip) {
  const auto faces = domain.boundary.faces();
  std::vector<Vector> v;
  for (const BoundaryFace& face : faces)
    v.push_back({face.side == Side::right && face.position.y < -5.0 ? 3.0 + slip : 3.0, 0.0});
  const std::vector<eq6::FreeField> free_field(faces.size(), {{3.0, 0.0}, {}});
  LostHold hold(domain, domain.sets, domain.boundary, true, 1.0);
  constexpr int rows = 50;
  for (int row = 1; row <= rows; ++row)
    hold.add(seconds * row / rows, v, free_field);
  return hold;
}

TEST(LostHold, TellsWhereSoilHasMovedMoreThanACellBeyondItsFreeField) {
  Domain domain(test_support::elastic_box(20.0, 10.0, 1.0));
  EXPECT_EQ(after(4.0, domain, 0.2).warning(), std::nullopt); // 0.8 m
  const auto told = after(10.0, domain, 0.2).warning();
  ASSERT_TRUE(told);
  EXPECT_THAT(*told, HasSubstr("soil has moved out of the model by 2 m at the right side, x = 20 m, y = "));
  EXPECT_THAT(*after(10.0, domain, -0.2).warning(), HasSubstr("into the model by 2 m"));
}

TEST(LostHold, GoesOnFromACheckpoint) {
  Domain domain(test_support::elastic_box(20.0, 10.0, 1.0));
  LostHold before = after(10.0, domain, 0.2);
  SavedNumbers numbers;
  before.add_state(numbers);
  test_support::SavedState saved;
  numbers.save("hold", saved);
  LostHold again(domain, domain.sets, domain.boundary, true, 1.0);
  SavedNumbers numbers_again;
  again.add_state(numbers_again);
  numbers_again.restore("hold", saved);
  EXPECT_EQ(again.warning(), before.warning());
}

/// Dry sand at rest with K0 = 1 in a box whose springs pull because its free field has begun to move.
class PulledSand {
public:
  explicit PulledSand(std::optional<materials::Elasticity> below = std::nullopt) : domain_(spec(below)) {
    for (Particles& set : domain_.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        set.sxx[k] = set.syy[k] = set.szz[k] = 1700.0 * 9.81 * set.y[k];
    hold_.emplace(domain_, domain_.sets, domain_.boundary, true, 1.0);
  }
  /// The free field moves to the left, m/s, until so many faces of the left side pull with more than the
  /// strength of their soil.
  void pull(double speed, std::ptrdiff_t faces) {
    Stepper stepper(domain_, 0.0, [speed](long, double, auto, std::span<eq6::FreeField> field) {
      std::ranges::fill(field, eq6::FreeField{{-speed, 0.0}, {}});
    });
    for (int step = 0; step < 1000 && overloaded() < faces; ++step)
      stepper.step();
  }
  std::ptrdiff_t overloaded(Side side = Side::left, double share = 1.0) const {
    return std::ranges::count_if(hold_->faces(), [side, share](const FaceDrift& face) {
      return face.side == side && face.strength_share > share;
    });
  }
  std::optional<std::string> warning() const { return hold_->warning(); }

private:
  static Spec spec(std::optional<materials::Elasticity> below) {
    Spec spec = test_support::elastic_box(20.0, 10.0, 1.0);
    materials::MohrCoulomb sand{.elastic = {1700.0, 40e6, 0.28}};
    sand.friction_peak = sand.friction_residual = std::numbers::pi / 6.0;
    spec.soils.front().law = sand;
    spec.below_base = below;
    for (const Side side : {Side::left, Side::right, Side::base})
      spec.springs.push_back({side, 1.0, 0.5, {10.0, 0.0}});
    return spec;
  }
  Domain domain_;
  std::optional<LostHold> hold_;
};

// The soil of the topmost face bears almost nothing: the ground beyond hands its pull to what lies below.
TEST(LostHold, IsSilentWhereOneFaceNearTheSurfaceIsOverloaded) {
  PulledSand sand;
  sand.pull(1.0, 1);
  ASSERT_EQ(sand.overloaded(), 1);
  EXPECT_EQ(sand.warning(), std::nullopt);
}

TEST(LostHold, WarnsWhereASideAsksForMoreThanTheStrengthOfItsSoil) {
  PulledSand sand;
  sand.pull(20.0, 9);
  ASSERT_EQ(sand.overloaded(), 9);
  ASSERT_TRUE(sand.warning());
  EXPECT_THAT(*sand.warning(),
              HasSubstr("the springs at the left side pull with more than the strength of the soil"));
}

TEST(LostHold, LooksForNoStrengthInRock) {
  PulledSand on_sand;
  PulledSand on_rock(materials::Elasticity{2200.0, 1.3e9, 0.4});
  for (PulledSand* const sand : {&on_sand, &on_rock})
    sand->pull(20.0, 9);
  EXPECT_GT(on_sand.overloaded(Side::base, 0.0), 0);
  EXPECT_EQ(on_rock.overloaded(Side::base, 0.0), 0);
}

} // namespace
} // namespace tremolo::mpm_domain
