// How far soil has moved through its dashpots, and when that is told.

#include "mpm_domain/boundary/drift/lost_hold.hpp"

#include "tests/support/box_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  LostHold hold(domain, domain.boundary, true, 1.0);
  constexpr int rows = 50;
  for (int row = 1; row <= rows; ++row)
    hold.add(seconds * row / rows, v, free_field);
  return hold;
}

TEST(LostHold, TellsWhereSoilHasMovedMoreThanACellBeyondItsFreeField) {
  Domain domain(test_support::elastic_box(20.0, 10.0, 1.0));
  domain.boundary.build_supports(domain);
  EXPECT_EQ(after(4.0, domain, 0.2).warning(), std::nullopt); // 0.8 m
  const auto told = after(10.0, domain, 0.2).warning();
  ASSERT_TRUE(told);
  EXPECT_THAT(*told, HasSubstr("soil has moved out of the model by 2 m at the right side, x = 20 m, y = "));
  EXPECT_THAT(*after(10.0, domain, -0.2).warning(), HasSubstr("into the model by 2 m"));
}

TEST(LostHold, GoesOnFromACheckpoint) {
  Domain domain(test_support::elastic_box(20.0, 10.0, 1.0));
  domain.boundary.build_supports(domain);
  const LostHold before = after(10.0, domain, 0.2);
  LostHold again(domain, domain.boundary, true, 1.0);
  again.set_state(before.state());
  EXPECT_EQ(again.warning(), before.warning());
}

} // namespace
} // namespace tremolo::mpm_domain
