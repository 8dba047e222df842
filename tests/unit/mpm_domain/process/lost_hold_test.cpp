// How far soil has moved through its dashpots, and when that is told.

#include "mpm_domain/process/lost_hold.hpp"

#include "tests/support/box_run.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/scene/case_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using ::testing::HasSubstr;

scene::Case flat(bool gravity) {
  std::string text(scene::testing::flat_case);
  if (gravity)
    text.insert(text.find("[[stage]]"), "[[stage]]\nkind = \"gravity\"\n");
  return scene::parse(text, "flat.toml", ".");
}

/// Both free field and soil move with 3 m/s; the soil at the right side below y = -5 m by `slip` m/s more.
LostHold after(double seconds, const scene::Case& scene, const Domain& domain, double slip) {
  const auto faces = domain.boundary.faces();
  std::vector<Vector> v;
  for (const BoundaryFace& face : faces)
    v.push_back({face.side == Side::right && face.position.y < -5.0 ? 3.0 + slip : 3.0, 0.0});
  const std::vector<eq6::FreeField> free_field(faces.size(), {{3.0, 0.0}, {}});
  LostHold hold(scene, domain.boundary);
  constexpr int rows = 50;
  for (int row = 1; row <= rows; ++row)
    hold.add(seconds * row / rows, v, free_field);
  return hold;
}

TEST(LostHold, TellsWhereSoilHasMovedMoreThanACellBeyondItsFreeField) {
  const scene::Case scene = flat(true);
  Domain domain(test_support::elastic_box(20.0, 10.0, 1.0));
  domain.boundary.build_supports(domain);
  EXPECT_EQ(after(4.0, scene, domain, 0.2).warning(), std::nullopt); // 0.8 m
  const auto told = after(10.0, scene, domain, 0.2).warning();
  ASSERT_TRUE(told);
  EXPECT_THAT(*told, HasSubstr("soil has moved out of the model by 2 m at the right side, x = 20 m, y = "));
  EXPECT_THAT(*after(10.0, scene, domain, -0.2).warning(), HasSubstr("into the model by 2 m"));
}

TEST(LostHold, IsNoneWhereNothingWasHeld) {
  const scene::Case scene = flat(false);
  Domain domain(test_support::elastic_box(20.0, 10.0, 1.0));
  domain.boundary.build_supports(domain);
  EXPECT_EQ(after(10.0, scene, domain, 0.2).warning(), std::nullopt);
}

TEST(LostHold, GoesOnFromACheckpoint) {
  const scene::Case scene = flat(true);
  Domain domain(test_support::elastic_box(20.0, 10.0, 1.0));
  domain.boundary.build_supports(domain);
  const testing::TemporaryFolder folder;
  const results::CheckpointIdentity identity{"domain", "00000000", 1};
  const LostHold before = after(10.0, scene, domain, 0.2);
  {
    results::CheckpointWriter file(folder / "state.h5", identity);
    before.save(file);
    file.close();
  }
  LostHold again(scene, domain.boundary);
  again.restore(results::CheckpointReader(folder / "state.h5", identity));
  EXPECT_EQ(again.warning(), before.warning());
}

} // namespace
} // namespace tremolo::mpm_domain
