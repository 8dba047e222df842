// From a case with a structure to the domain, and from there to the run's file.

#include "mpm_domain/process/run_output.hpp"
#include "mpm_domain/process/spec_from_case.hpp"

#include "mpm_domain/boundary/static_traction.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "results/run_file.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/scene/structure_case.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using ::testing::ElementsAre;

/// A row in every step.
scene::Case block_case() {
  return scene::testing::parse_case(scene::testing::with_block() +
                                    "[output]\nevery_s = 1.0\nhistory_every_s = 1e-4\n");
}

TEST(SpecFromCase, HandsStructuresOn) {
  const scene::Case scene = scene::testing::parse_case(scene::testing::with(
      "size = 1.0", "size = 1.0\ncontact_normals = \"polygon\"",
      scene::testing::with_block() +
          "adhesion = 1e3\nhole = [[9.0, 1.0], [11.0, 1.0], [11.0, 3.0]]\n"
          "against = [{ soil = \"clay\", friction = 0.3 }]\n"
          "[soil.clay]\nmodel = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.28\n"));
  const Spec spec = spec_from_case(scene, 1);
  EXPECT_EQ(spec.normals, ContactNormals::polygon);
  ASSERT_EQ(spec.structures.size(), 1U);
  const Structure& block = spec.structures[0];
  EXPECT_EQ(block.name, "block");
  ASSERT_EQ(block.outline.size(), 4U);
  EXPECT_EQ(block.outline[1].x, 12.0);
  EXPECT_EQ(block.outline[3].y, 4.0);
  ASSERT_EQ(block.hole.size(), 3U);
  EXPECT_EQ(block.hole[2].y, 3.0);
  EXPECT_EQ(block.density, 1000.0);
  EXPECT_EQ(block.friction_between, 0.5);
  ASSERT_EQ(spec.soils.size(), 2U);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(block.friction.at(s), spec.soils[s].name == "clay" ? 0.3 : 0.5);
    EXPECT_EQ(block.adhesion.at(s), 1e3);
  }
}

/// A domain at rest with the block on it, and what is written of it.
class BlockRun {
public:
  explicit BlockRun(const std::filesystem::path& folder)
      : scene_(block_case()), domain_(spec_from_case(scene_, 1)),
        stepper_(at_rest(), 0.0, test_support::quiet_ground()),
        output_(folder, scene_, "{}", domain_,
                std::vector<std::string>(domain_.boundary.faces().size(), "wave")) {}

  void step(int count) {
    for (; count > 0; --count) {
      stepper_.step();
      output_.after_step(stepper_);
    }
  }
  Domain& domain() { return domain_; }
  Stepper& stepper() { return stepper_; }
  RunOutput& output() { return output_; }
  const RigidBody& body() const { return domain_.contact.bodies().front(); }

private:
  Domain& at_rest() {
    const Reactions reactions = relax_under_gravity(domain_, {.residual = 1e-9}, [](long, double) {});
    replace_constraints(domain_, reactions);
    return domain_;
  }

  scene::Case scene_;
  Domain domain_;
  Stepper stepper_;
  RunOutput output_;
};

/// State of bodies by name.
class BodyState {
public:
  void write(const std::string& name, const std::vector<double>& values) { values_[name] = values; }
  std::vector<double> numbers(const std::string& name) const { return values_.at(name); }
  std::vector<double>& of(const std::string& name) { return values_.at(name); }

private:
  std::map<std::string, std::vector<double>> values_;
};

void push(Contact& contact) {
  BodyState state;
  contact.save(state);
  state.of("body0").at(3) = 0.02; // vx
  state.of("body0").at(5) = 1e-3; // spin
  contact.restore(state);
}

double last(const results::SeriesData& series, std::string_view column) {
  const auto at =
      static_cast<std::size_t>(std::ranges::find(series.columns, column) - series.columns.begin());
  return series.values.at((series.rows() - 1) * series.columns.size() + at);
}

TEST(RunOutput, FollowsBodiesAndTheirForces) {
  const testing::TemporaryFolder folder;
  BlockRun run(folder / "");
  // A push tells the time of its velocity from that of its place.
  push(run.domain().contact);
  run.step(3);
  const double back = 0.5 * run.stepper().dt();
  const RigidMotion u = run.body().motion();
  run.output().finish(run.stepper(), 0.0, 0.0);

  const results::SeriesData block = results::RunReader(folder / "run.h5").series("/bodies/block");
  EXPECT_THAT(block.columns,
              ElementsAre("time", "x", "y", "tilt", "vx", "vy", "spin", "normal_x", "normal_y",
                          "normal_moment", "friction_x", "friction_y", "friction_moment", "water_x",
                          "water_y", "water_moment", "weight_x", "weight_y", "weight_moment"));
  EXPECT_THAT(block.units, ElementsAre("s", "m", "m", "rad", "m/s", "m/s", "rad/s", "N/m", "N/m", "N", "N/m",
                                       "N/m", "N", "N/m", "N/m", "N", "N/m", "N/m", "N"));
  ASSERT_EQ(block.rows(), 3U);
  EXPECT_NE(u.velocity.x, 0.0);
  EXPECT_EQ(last(block, "time"), run.stepper().velocity_time());
  EXPECT_EQ(last(block, "vx"), u.velocity.x);
  EXPECT_EQ(last(block, "spin"), u.spin);
  EXPECT_DOUBLE_EQ(last(block, "x"), run.body().centre().x - back * u.velocity.x);
  EXPECT_DOUBLE_EQ(last(block, "tilt"), run.body().tilt() - back * u.spin);
  EXPECT_DOUBLE_EQ(last(block, "weight_y"), -16000.0 * 9.81);
  EXPECT_EQ(last(block, "normal_y"), run.domain().contact.forces(0).normal.force.y);
  EXPECT_EQ(last(block, "friction_moment"), run.domain().contact.forces(0).friction.moment);
}

TEST(RunOutput, GoesOnWithBodiesWhereACheckpointWas) {
  const testing::TemporaryFolder folder;
  const results::CheckpointIdentity identity{"domain", "00000000", 2};
  test_support::SavedState state;
  {
    BlockRun whole(folder / "");
    whole.step(2);
    results::CheckpointWriter checkpoint(folder / "domain.h5", identity);
    whole.output().save(checkpoint);
    checkpoint.close();
    state = test_support::saved_state(whole.domain(), whole.stepper());
    whole.step(2);
    whole.output().finish(whole.stepper(), 0.0, 0.0);
  }
  const auto all = results::RunReader(folder / "run.h5").series("/bodies/block");
  ASSERT_EQ(all.rows(), 4U);
  const std::filesystem::path before = results::set_aside(folder / "run.h5");
  BlockRun resumed(folder / "");
  test_support::restore_state(state, resumed.domain(), resumed.stepper());
  resumed.output().take_over(before, results::CheckpointReader(folder / "domain.h5", identity));
  resumed.step(2);
  resumed.output().finish(resumed.stepper(), 0.0, 0.0);
  EXPECT_EQ(results::RunReader(folder / "run.h5").series("/bodies/block").values, all.values);
}

} // namespace
} // namespace tremolo::mpm_domain
