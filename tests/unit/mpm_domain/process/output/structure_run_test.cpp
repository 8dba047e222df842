// From a case with a structure to the domain, and from there to the run's file.

#include "mpm_domain/process/output/run_output.hpp"
#include "mpm_domain/process/spec_from_case.hpp"

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "results/run_file.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/scene/structure_case.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using ::testing::ElementsAre;

constexpr std::string_view rigid = "rigid = true";
constexpr std::string_view elastic = "young = 20e6\npoisson = 0.2";

/// A row and a frame in every step, and a monitor at a corner.
scene::Case block_case(std::string_view kind) {
  return scene::testing::parse_case(
      scene::testing::with(rigid, kind, scene::testing::with_block()) +
      "[[monitor]]\nname = \"corner\"\npoint = [12.0, 4.0]\nstructure = \"block\"\n"
      "[output]\nevery_s = 1e-4\nhistory_every_s = 1e-4\n");
}

/// A hole in walls of one cell, which a case cannot have.
scene::Case with_hole(scene::Case scene, scene::Polygon hole) {
  if (!hole.empty())
    scene.structures.front().hole = scene::Outline{"hole", std::move(hole)};
  return scene;
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
  EXPECT_FALSE(block.stiffness);
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

TEST(SpecFromCase, HandsStiffnessOn) {
  const Spec spec = spec_from_case(block_case(elastic), 1);
  ASSERT_TRUE(spec.structures.at(0).stiffness);
  EXPECT_EQ(spec.structures[0].stiffness->young, 20e6);
  EXPECT_EQ(spec.structures[0].stiffness->poisson, 0.2);
}

/// A domain at rest with the block on it, and what is written of it.
class BlockRun {
public:
  explicit BlockRun(const std::filesystem::path& folder, std::string_view kind = rigid,
                    scene::Polygon hole = {})
      : scene_(with_hole(block_case(kind), std::move(hole))), domain_(spec_from_case(scene_, 1)),
        stepper_(at_rest(), 0.0, test_support::quiet_ground()),
        output_(folder, scene_, "{}", domain_, domain_.sets, snapshot_,
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
  Snapshot snapshot_{domain_};
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
  run.output().write_last(run.stepper());
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

/// Sums over the contact nodes of a frame, body after body alike.
struct ContactSums {
  Vector normal, friction, water;
  double area = 0.0;
};

ContactSums contact_sums(const results::RunReader& run, std::size_t frame) {
  const auto field = [&](const char* name) { return run.part_field("contact", frame, name).values; };
  const auto n = field("normal");
  const auto normal = field("normal_force");
  const auto friction = field("friction_force");
  const auto water = field("water_force");
  const auto area = field("area");
  ContactSums sums;
  for (std::size_t k = 0; k < area.size(); ++k) {
    const Vector out{n.at(2 * k), n.at(2 * k + 1)};
    EXPECT_NEAR(std::hypot(out.x, out.y), 1.0, 1e-12);
    sums.normal = {sums.normal.x + normal.at(k) * out.x, sums.normal.y + normal.at(k) * out.y};
    sums.friction = {sums.friction.x - friction.at(k) * out.y, sums.friction.y + friction.at(k) * out.x};
    sums.water = {sums.water.x + water.at(k) * out.x, sums.water.y + water.at(k) * out.y};
    sums.area += area.at(k);
  }
  return sums;
}

TEST(RunOutput, ContactNodesAddUpToTheForcesOnTheBody) {
  const testing::TemporaryFolder folder;
  BlockRun run(folder / "");
  push(run.domain().contact);
  run.step(3);
  const BodyForces forces = run.domain().contact.forces(0);
  run.output().write_last(run.stepper());
  run.output().finish(run.stepper(), 0.0, 0.0);

  const results::RunReader file(folder / "run.h5");
  EXPECT_THAT(std::get<std::vector<std::string>>(file.attribute("structure_names")), ElementsAre("block"));
  ASSERT_EQ(file.frame_times().size(), 3U);
  EXPECT_THAT(file.part_fields("contact", 2), ElementsAre("area", "body", "friction_force", "normal",
                                                          "normal_force", "position", "water_force"));
  EXPECT_EQ(file.part_field("contact", 2, "normal_force").unit, "N/m");
  EXPECT_TRUE(file.part_field("contact", 2, "body").integers);
  const ContactSums sums = contact_sums(file, 2);
  const double weight = 16000.0 * 9.81;
  EXPECT_NEAR(sums.normal.x, forces.normal.force.x, 1e-9 * weight);
  EXPECT_NEAR(sums.normal.y, forces.normal.force.y, 1e-9 * weight);
  EXPECT_NEAR(sums.friction.x, forces.friction.force.x, 1e-9 * weight);
  EXPECT_NE(sums.friction.x, 0.0);
  EXPECT_EQ(sums.water.y, 0.0);
  EXPECT_NEAR(sums.area, 4.0, 1.0); // of a foot of 4 m; nodes reach a cell beyond
  const auto position = file.part_field("contact", 2, "position").values;
  for (std::size_t k = 0; k < position.size(); k += 2) {
    EXPECT_NEAR(position[k], 10.0, 3.01);
    EXPECT_NEAR(position[k + 1], 0.0, 1.01);
  }
}

/// V + omega x r of the corner and its change, from the body's own numbers.
TEST(RunOutput, MonitorsMoveWithTheirBody) {
  const testing::TemporaryFolder folder;
  BlockRun run(folder / "");
  push(run.domain().contact);
  run.step(3);
  run.output().write_last(run.stepper());
  run.output().finish(run.stepper(), 0.0, 0.0);

  const results::RunReader file(folder / "run.h5");
  const results::SeriesData body = file.series("/bodies/block");
  const results::SeriesData corner = file.series("/monitors/corner");
  EXPECT_THAT(corner.columns, ElementsAre("time", "x", "y", "ux", "uy", "vx", "vy", "ax", "ay"));
  ASSERT_EQ(corner.rows(), 3U);
  const double tilt = last(body, "tilt");
  ASSERT_NE(tilt, 0.0);
  // From the centre of mass: (2, 2) m.
  const Vector arm{2.0 * std::cos(tilt) - 2.0 * std::sin(tilt), 2.0 * std::sin(tilt) + 2.0 * std::cos(tilt)};
  EXPECT_DOUBLE_EQ(last(corner, "x"), last(body, "x") + arm.x);
  EXPECT_DOUBLE_EQ(last(corner, "y"), last(body, "y") + arm.y);
  EXPECT_NEAR(last(corner, "ux"), last(corner, "x") - 12.0, 1e-14);
  EXPECT_NEAR(last(corner, "uy"), last(corner, "y") - 4.0, 1e-14);
  EXPECT_DOUBLE_EQ(last(corner, "vx"), last(body, "vx") - last(body, "spin") * arm.y);
  EXPECT_DOUBLE_EQ(last(corner, "vy"), last(body, "vy") + last(body, "spin") * arm.x);
  const auto value = [&](std::size_t row, std::size_t column) {
    return corner.values.at(row * corner.columns.size() + column);
  };
  const double interval = value(2, 0) - value(1, 0);
  EXPECT_NEAR(value(2, 7), (value(2, 5) - value(1, 5)) / interval, 1e-9 * std::abs(value(2, 7)));
  EXPECT_NEAR(value(2, 8), (value(2, 6) - value(1, 6)) / interval, 1e-9 * std::abs(value(2, 8)));
}

TEST(RunOutput, FollowsAPointOfAnElasticBody) {
  const testing::TemporaryFolder folder;
  BlockRun run(folder / "", elastic);
  for (Particles& set : run.domain().sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k)
      set.vx[k] = 0.02;
  run.domain().spec.gravity *= 0.5;
  run.step(3);
  const Particles& set = run.domain().body_sets().front();
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < set.size(); ++k)
    if (set.x_initial[k] + set.y_initial[k] > set.x_initial[nearest] + set.y_initial[nearest])
      nearest = k;
  const double vx = set.vx[nearest];
  const double sxx = set.sxx[nearest];
  const double acceleration = particle_acceleration(run.domain(), set, nearest).x;
  run.output().write_last(run.stepper());
  run.output().finish(run.stepper(), 0.0, 0.0);

  const results::RunReader file(folder / "run.h5");
  const results::SeriesData corner = file.series("/monitors/corner");
  EXPECT_EQ(last(corner, "vx"), vx);
  EXPECT_NEAR(last(corner, "ux"), 0.02 * last(corner, "time"), 1e-3 * 0.02 * last(corner, "time"));
  EXPECT_EQ(last(corner, "ax"), acceleration);
  EXPECT_NEAR(last(corner, "ay"), 0.5 * 9.81, 0.05 * 9.81); // its stress bears the weight that is gone
  EXPECT_NE(sxx, 0.0);
  const results::SeriesData block = file.series("/bodies/block");
  EXPECT_NEAR(last(block, "vx"), 0.02, 4e-3); // friction slows it down
  EXPECT_DOUBLE_EQ(last(block, "weight_y"), -8000.0 * 9.81);
  // Frames hold the soil; the block's particles stand beside it, with its stress.
  std::size_t of_soil = 0;
  for (const Particles& soil : run.domain().sets_of_soil())
    of_soil += soil.size();
  EXPECT_EQ(file.frame_field(0, "soil").values.size(), of_soil);
  std::size_t of_block = 0;
  for (const Particles& particles : run.domain().body_sets())
    of_block += particles.size();
  const std::size_t end = file.frame_times().size() - 1;
  EXPECT_THAT(file.part_fields("structures", end),
              ElementsAre("body", "displacement", "position", "size", "stress"));
  EXPECT_EQ(file.part_field("structures", end, "body").values, std::vector<double>(of_block, 0.0));
  const std::vector<double> stresses = file.part_field("structures", end, "stress").values;
  ASSERT_EQ(stresses.size(), 4 * of_block);
  bool found = false;
  for (std::size_t k = 0; k < of_block; ++k)
    found |= stresses[4 * k] == sxx;
  EXPECT_TRUE(found);
}

/// The block's particles move aside with the square of their height: its outline bends as they do.
TEST(RunOutput, TellsTheBentOutlineOfAnElasticBody) {
  const testing::TemporaryFolder folder;
  BlockRun run(folder / "", elastic, {{9.0, 1.0}, {11.0, 1.0}, {11.0, 3.0}});
  constexpr double bend = 0.002; // 1/m
  for (Particles& set : run.domain().sets)
    for (std::size_t k = 0; set.body && k < set.size(); ++k)
      set.x[k] += bend * set.y[k] * set.y[k];
  run.step(1);
  run.output().write_last(run.stepper());
  run.output().finish(run.stepper(), 0.0, 0.0);
  const results::RunReader file(folder / "run.h5");
  const results::SeriesData outline = file.series("/outlines/block");
  ASSERT_EQ(outline.rows(), file.frame_times().size());
  // A point a cell of a metre at most: 4 on each side of the block, 2, 2 and 3 on those of the hole.
  ASSERT_EQ(outline.columns.size(), 1U + 2U * (16U + 7U));
  EXPECT_EQ(outline.columns.back(), "hole_y6");
  EXPECT_EQ(outline.units.back(), "m");
  // On the right side, 4, 2 and 0 m high. The particles that these go with are a quarter of a metre off.
  const double second_difference = last(outline, "x8") - 2.0 * last(outline, "x6") + last(outline, "x4");
  EXPECT_NEAR(second_difference, bend * 8.0, 0.5 * bend * 8.0);
  EXPECT_NEAR(last(outline, "x8") - last(outline, "x4"), bend * 16.0, 0.25 * bend * 16.0);
  EXPECT_NEAR(last(outline, "hole_x4") - last(outline, "hole_x2"), bend * 8.0, 0.25 * bend * 8.0);
}

class Resumed : public ::testing::TestWithParam<std::string_view> {};

TEST_P(Resumed, GoesOnWithBodiesWhereACheckpointWas) {
  const testing::TemporaryFolder folder;
  const results::CheckpointIdentity identity{"domain", "00000000", 2};
  test_support::SavedState state;
  {
    BlockRun whole(folder / "", GetParam());
    whole.step(2);
    results::CheckpointWriter checkpoint(folder / "domain.h5", identity);
    whole.output().save(checkpoint);
    checkpoint.close();
    state = test_support::saved_state(whole.domain(), whole.stepper());
    whole.step(2);
    whole.output().write_last(whole.stepper());
    whole.output().finish(whole.stepper(), 0.0, 0.0);
  }
  const auto contents = [&] {
    const results::RunReader run(folder / "run.h5");
    std::vector<std::vector<double>> all{run.series("/bodies/block").values,
                                         run.series("/monitors/corner").values};
    if (GetParam() == elastic)
      all.push_back(run.series("/outlines/block").values);
    for (std::size_t frame = 0; frame < run.frame_times().size(); ++frame)
      for (const std::string& name : run.part_fields("contact", frame))
        all.push_back(run.part_field("contact", frame, name).values);
    return all;
  };
  const auto all = contents();
  ASSERT_EQ(all.size(), (GetParam() == elastic ? 3U : 2U) + 4U * 7U);
  const std::filesystem::path before = results::set_aside(folder / "run.h5");
  BlockRun resumed(folder / "", GetParam());
  test_support::restore_state(state, resumed.domain(), resumed.stepper());
  resumed.output().take_over(before, results::CheckpointReader(folder / "domain.h5", identity));
  resumed.step(2);
  resumed.output().write_last(resumed.stepper());
  resumed.output().finish(resumed.stepper(), 0.0, 0.0);
  EXPECT_EQ(contents(), all);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Resumed, ::testing::Values(rigid, elastic));

} // namespace
} // namespace tremolo::mpm_domain
