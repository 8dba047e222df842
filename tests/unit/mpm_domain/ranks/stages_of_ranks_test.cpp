// Ranks share the static stages, which have the same bits as those of one process. Rank 0 makes these alone
// as well, and compares.

#include "mpm_domain/gravity/static_stages.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/unit/mpm_domain/ranks/structure_models.hpp"
#include "tests/unit/mpm_domain/ranks/test_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo {
namespace {

using mpm_domain::Domain;
using mpm_domain::Reactions;
using mpm_domain::Spec;
using mpm_domain::StaticStage;
using mpm_domain::StaticStages;
using test_support::SavedState;

constexpr double residual = 4e-2; // bits show long before rest

/// A box of 100 m by 40 m, and what comes after gravity.
struct Site {
  const char* name;
  std::function<void(Spec&, std::vector<StaticStage>&)> change;
};

mpm_domain::StageSettings settings() {
  return {.ramp = 0.05, .residual = residual, .max_time = 20.0};
}

/// Two loads, the first of which undrained soil carries.
void load_wet_ground(Spec& spec, std::vector<StaticStage>& stages) {
  test_support::add_water(spec, materials::Drainage::coupled);
  spec.loads = {{.x_min = 20.0, .x_max = 40.5, .pressure = 2e4, .shear = 1e3},
                {.x_min = 60.0, .x_max = 62.0, .pressure = 5e4, .shear = 0.0}};
  mpm_domain::StageSettings undrained = settings();
  undrained.undrained = {true};
  stages = {mpm_domain::LoadSettings{undrained, 0}, mpm_domain::LoadSettings{settings(), 1}};
}

/// One block of two goes, which then stands no more when the walls are loaded.
void build_and_remove(Spec& spec, std::vector<StaticStage>& stages) {
  test_support::add_propped_walls(spec);
  const std::vector<mpm_domain::Structure> walls = spec.structures;
  test_support::add_block(spec, "goes", test_support::rectangle(12.0, -4.0, 18.0, 4.0));
  const std::vector<mpm_domain::Structure> all = spec.structures;
  spec.structures = walls;
  spec.structure_loads = {{.structure = "left", .force = {-1e4, -2e4}}};
  mpm_domain::ConstructionSettings with_block;
  static_cast<mpm_domain::StageSettings&>(with_block) = settings();
  with_block.regions = spec.regions;
  with_block.structures = all;
  stages = {with_block, mpm_domain::LoadSettings{settings(), 0, true}};
}

/// A trench beside an elastic wall and over a lining is dug on a graded mesh, while the water falls; a bank
/// comes to lie beside it.
void dig_and_fill(Spec& spec, std::vector<StaticStage>& stages) {
  spec = test_support::elastic_box(200.0, 40.0, 2.0);
  test_support::add_water(spec, materials::Drainage::coupled);
  test_support::add_lining(spec);
  spec.refine = {{{20.0, -22.0, 60.0, 8.0}, 1}};
  spec.box.y_max = 8.0;
  spec.cut_at_edges = true;
  test_support::add_block(spec, "wall", test_support::rectangle(25.0, -6.0, 26.5, 1.3)).stiffness =
      mpm_domain::Stiffness{2e8, 0.2};
  const mpm_domain::Region below{0, {{0.0, -40.0}, {200.0, -40.0}, {200.0, -4.0}, {0.0, -4.0}}};
  const mpm_domain::Region left{0, {{0.0, -4.0}, {26.5, -4.0}, {26.5, 0.0}, {0.0, 0.0}}};
  const mpm_domain::Region trench{0, {{26.5, -4.0}, {45.2, -4.0}, {46.3, 0.0}, {26.5, 0.0}}};
  const mpm_domain::Region right{0, {{45.2, -4.0}, {200.0, -4.0}, {200.0, 0.0}, {46.3, 0.0}}};
  const mpm_domain::Region bank{0, {{60.0, 0.0}, {90.0, 0.0}, {85.0, 3.0}, {65.0, 3.0}}};
  mpm_domain::ConstructionSettings dug;
  static_cast<mpm_domain::StageSettings&>(dug) = settings();
  dug.regions = {below, left, trench, right};
  dug.structures = spec.structures;
  dug.water = spec.water;
  mpm_domain::ConstructionSettings banked = dug;
  banked.regions = {below, left, right};
  spec.water->level = -22.0;
  banked.water = spec.water;
  spec.regions = {below, left, right, bank};
  stages = {dug, banked};
}

const Site sites[] = {
    {"Level", [](Spec& spec, auto&) { spec.gravity = 9.81, test_support::yield(spec); }},
    {"Building",
     [](Spec& spec, auto&) {
       test_support::add_block(spec, "building", test_support::rectangle(26.0, -4.0, 38.0, 6.0));
     }},
    {"Neighbours", [](Spec& spec, auto&) { test_support::add_neighbours(spec); }},
    {"Lining", [](Spec& spec, auto&) { test_support::add_lining(spec); }},
    {"Levels",
     [](Spec& spec, auto&) {
       spec.gravity = 9.81;
       test_support::refine_corner(spec);
     }},
    {"Periodic",
     [](Spec& spec, auto&) {
       spec.gravity = 9.81;
       test_support::make_periodic(spec);
     }},
    {"WetGround",
     [](Spec& spec, auto&) {
       test_support::add_water(spec, materials::Drainage::coupled);
       test_support::yield(spec);
     }},
    {"Sharp",
     [](Spec& spec, auto&) {
       spec.gravity = 9.81;
       spec.scheme.dispersion = mpm_domain::Dispersion::reduced;
     }},
    {"LoadedSharp",
     [](Spec& spec, std::vector<StaticStage>& stages) {
       spec.gravity = 9.81;
       spec.scheme.dispersion = mpm_domain::Dispersion::reduced;
       spec.loads = {{.x_min = 20.0, .x_max = 40.5, .pressure = 2e4, .shear = 1e3}};
       stages = {mpm_domain::LoadSettings{settings(), 0}};
     }},
    {"LoadedWetGround", load_wet_ground},
    {"BlockThatGoes", build_and_remove},
    {"Trench", dig_and_fill},
};

class StagesOfRanks : public testing::TestWithParam<Site> {
protected:
  StagesOfRanks() {
    spec_ = test_support::elastic_box(100.0, 40.0, 1.0);
    GetParam().change(spec_, stages_);
  }

  StaticStages walk(Domain& end) const {
    return {end, {.residual = residual}, stages_, [](std::size_t, long, double) {}};
  }

  /// What a run could go on from after a stage.
  static SavedState saved(const StaticStages& walk) {
    SavedState state;
    mpm_domain::AllParticles particles(walk.model());
    particles.show({}, [&] { walk.save(particles, state); });
    return state;
  }

  /// A few steps from rest on, and the state then.
  static SavedState shake(Domain& domain) {
    mpm_domain::Stepper stepper(domain, 0.0, test_support::quiet_ground());
    for (int step = 0; step < 5; ++step)
      stepper.step();
    SavedState state;
    domain.boundary.tell_first(domain);
    mpm_domain::AllParticles particles(domain);
    particles.show({}, [&] {
      save(domain, particles, state);
      stepper.save(state);
    });
    return state;
  }

  Spec spec_;
  std::vector<StaticStage> stages_;
};

void expect_same(const Reactions& one, const Reactions& other) {
  EXPECT_EQ(one.base, other.base);
  EXPECT_EQ(one.sides, other.sides);
  EXPECT_EQ(one.slipping_bodies, other.slipping_bodies);
  ASSERT_EQ(one.force.size(), other.force.size());
  for (std::size_t n = 0; n < one.force.size(); ++n) {
    EXPECT_EQ(one.force[n].x, other.force[n].x);
    EXPECT_EQ(one.force[n].y, other.force[n].y);
  }
  ASSERT_EQ(one.ways.size(), other.ways.size());
  for (std::size_t s = 0; s < one.ways.size(); ++s) {
    EXPECT_EQ(one.ways[s].way.y, other.ways[s].way.y);
    EXPECT_EQ(one.ways[s].turn, other.ways[s].turn);
  }
}

TEST_P(StagesOfRanks, HaveTheBitsOfOneProcess) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  std::optional<Domain> alone; // of rank 0
  std::optional<StaticStages> walk_alone;
  if (ranks.rank() == 0) {
    alone.emplace(spec_);
    walk_alone.emplace(walk(*alone));
  }
  Domain shared(spec_, &ranks);
  StaticStages walk_of_ranks = walk(shared);
  while (!walk_of_ranks.are_over()) {
    SCOPED_TRACE("stage " + std::to_string(walk_of_ranks.over()));
    walk_of_ranks.next();
    const SavedState state = saved(walk_of_ranks);
    if (!walk_alone)
      continue;
    walk_alone->next();
    expect_same(saved(*walk_alone), state);
  }
  const Reactions reactions = walk_of_ranks.finish();
  EXPECT_LT(shared.particle_count(), reactions.particles); // no rank has all
  replace_constraints(shared, reactions);
  const SavedState state = shake(shared);
  if (!alone)
    return;
  const Reactions reactions_alone = walk_alone->finish();
  EXPECT_EQ(reactions_alone.particles, alone->particle_count());
  EXPECT_EQ(reactions.particles, alone->particle_count());
  expect_same(reactions_alone, reactions);
  replace_constraints(*alone, reactions_alone);
  expect_same(shake(*alone), state);
}

class StagesBrokenOff : public StagesOfRanks {};

/// What one process has saved after a stage, ranks go on with.
TEST_P(StagesBrokenOff, GoOn) {
  TREMOLO_NEED_RANKS();
  Domain alone(spec_);
  StaticStages stages = walk(alone);
  std::vector<SavedState> after;
  while (!stages.are_over()) {
    stages.next();
    after.push_back(saved(stages));
  }
  for (std::size_t broken = 0; broken + 1 < after.size(); ++broken) {
    SCOPED_TRACE("after stage " + std::to_string(broken));
    Domain domain(spec_, test_support::test_ranks());
    StaticStages resumed = walk(domain);
    resumed.restore(after[broken]);
    while (!resumed.are_over())
      resumed.next();
    const SavedState state = saved(resumed);
    if (test_support::test_ranks()->rank() == 0)
      expect_same(after.back(), state);
  }
}

std::string name_of(const testing::TestParamInfo<Site>& of) {
  return of.param.name;
}

std::vector<Site> chosen(const std::vector<std::string_view>& names) {
  std::vector<Site> of_names;
  for (const std::string_view name : names)
    of_names.push_back(*std::ranges::find(sites, name, &Site::name));
  return of_names;
}

INSTANTIATE_TEST_SUITE_P(Sites, StagesOfRanks, testing::ValuesIn(sites), name_of);
INSTANTIATE_TEST_SUITE_P(Sites, StagesBrokenOff,
                         testing::ValuesIn(chosen({"LoadedWetGround", "BlockThatGoes"})), name_of);

/// Where the ground finds no rest, particles take the motion of its nodes.
TEST(Ranks, ShowWhereGroundFindsNoRest) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  Spec spec = test_support::elastic_box(100.0, 40.0, 1.0);
  test_support::add_building(spec);
  const auto fail = [&](mpm_domain::Communicator* with) {
    Domain domain(spec, with);
    StaticStages stages(domain, {.residual = 1e-9, .max_time = 0.1}, {}, [](std::size_t, long, double) {});
    EXPECT_THROW(stages.next(), mpm_domain::NotAtRest);
    take_velocities_of_nodes(domain);
    SavedState state;
    mpm_domain::AllParticles particles(domain);
    particles.show({}, [&] { save(domain, particles, state); });
    return state;
  };
  const SavedState shared = fail(&ranks);
  if (ranks.rank() != 0)
    return;
  const SavedState alone = fail(nullptr);
  expect_same(alone, shared);
  const std::vector<double> vy = alone.numbers("soil0.vy");
  EXPECT_NE(vy, std::vector<double>(vy.size(), 0.0));
}

} // namespace
} // namespace tremolo
