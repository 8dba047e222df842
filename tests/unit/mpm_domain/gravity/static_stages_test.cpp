// A walk through static stages that is broken off after any of them, and goes on from what it has saved, ends
// with the bits of one that was never broken.

#include "mpm_domain/gravity/static_stages.hpp"

#include "tests/support/saved_state.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::rectangle;
using test_support::SavedState;

constexpr StageSettings settings{.ramp = 0.3, .residual = 1e-4, .max_time = 20.0};
constexpr GravitySettings under_gravity{.residual = 1e-4};

Structure block(double x, const char* name, bool elastic) {
  Structure one = test_support::structure(rectangle(x, 0.0, x + 2.0, 1.0), 2000.0, 0.5);
  one.name = name;
  one.friction.push_back(0.5);
  one.adhesion.push_back(0.0);
  if (elastic)
    one.stiffness = Stiffness{1e8, 0.2};
  return one;
}

/// Wet ground that is loaded, and dug beside two blocks; one of these is loaded, and one goes while water
/// cannot flow; then a load comes whose stage is drained.
struct Site {
  Spec spec = test_support::flat_ground(12.0, 4.0, 1.0, {1900.0, 2e7, 0.3});
  std::vector<StaticStage> stages;

  Site() {
    spec.threads = 1;
    spec.water = {-1.0, {}};
    spec.soils.front().pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-4};
    spec.soils.push_back(spec.soils.front());
    spec.cut_at_edges = true;
    spec.loads = {{-5.0, -3.0, 10e3, 0.0}, {-5.0, -4.0, 5e3, 1e3}};
    spec.structure_loads = {{"stays", {1e3, -20e3}}};
    std::vector<Region> whole{{0, rectangle(-6.0, -4.0, 6.0, -1.0)},
                              {0, rectangle(-6.0, -1.0, 4.0, 0.0)},
                              {1, rectangle(4.0, -1.0, 6.0, 0.0)}};
    const std::vector<Structure> both{block(-3.0, "stays", true), block(1.0, "goes", false)};
    const std::vector<Region> dug{whole[0], whole[1]};
    stages = {LoadSettings{settings, 0}, ConstructionSettings{settings, whole, both, spec.water},
              LoadSettings{settings, 0, true}, ConstructionSettings{settings, dug, both, spec.water},
              LoadSettings{settings, 1}};
    std::get<ConstructionSettings>(stages[3]).undrained = {true};
    spec.regions = dug;
    spec.structures = {both.front()};
  }

  StaticStages walk(Domain& end) const {
    return {end, under_gravity, stages, [](std::size_t, long, double) {}};
  }
};

void save(const StaticStages& walk, SavedState& state) {
  walk.save(mpm_domain::AllParticles(walk.model()), state);
}

SavedState state_of(const Domain& domain, const Reactions& reactions) {
  SavedState state;
  save(domain, state);
  std::vector<double> numbers;
  for (const Vector& force : reactions.force)
    numbers.insert(numbers.end(), {force.x, force.y});
  for (const StructureWay& structure : reactions.ways)
    numbers.insert(numbers.end(), {structure.way.x, structure.way.y, structure.turn});
  state.write("reactions", numbers);
  return state;
}

TEST(StaticStages, GoOnWithTheSameBitsAfterAnyOfThem) {
  const Site site;
  Domain whole(site.spec);
  StaticStages walk = site.walk(whole);
  std::vector<SavedState> saved;
  while (!walk.are_over()) {
    walk.next();
    save(walk, saved.emplace_back());
  }
  const SavedState end = state_of(whole, walk.finish());
  ASSERT_EQ(saved.size(), site.stages.size() + 1);
  for (std::size_t broken = 0; broken + 1 < saved.size(); ++broken) {
    SCOPED_TRACE("after stage " + std::to_string(broken));
    Domain domain(site.spec);
    StaticStages resumed = site.walk(domain);
    resumed.restore(saved[broken]);
    EXPECT_EQ(resumed.over(), broken + 1);
    while (!resumed.are_over())
      resumed.next();
    expect_same(end, state_of(domain, resumed.finish()));
  }
}

TEST(StaticStages, RefuseTheStateOfOtherGround) {
  const Site site;
  Domain domain(site.spec);
  StaticStages walk = site.walk(domain);
  walk.next();
  SavedState saved;
  save(walk, saved);
  Site other;
  other.spec.box.x_max = 8.0;
  Domain wider(other.spec);
  StaticStages resumed = other.walk(wider);
  EXPECT_THROW(resumed.restore(saved), std::runtime_error);
}

TEST(StaticStages, AreShownAsTheyAreAndStaySo) {
  const Site site;
  Domain domain(site.spec);
  StaticStages walk = site.walk(domain);
  walk.next();
  walk.next();
  SavedState before;
  save(walk, before);
  double lowest = 0.0;
  walk.show([&](Domain& model) {
    for (Particles& set : model.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        lowest = std::min(lowest, set.y[k] - set.y_initial[k]);
        set.y[k] = 0.0;
      }
  });
  EXPECT_LT(lowest, -1e-4); // the load has pressed it down
  SavedState after;
  save(walk, after);
  expect_same(before, after);
}

/// The mean position of a polygon's corners.
Vector middle(const std::vector<Vector>& corners) {
  Vector sum;
  for (const Vector& corner : corners)
    sum = {sum.x + corner.x, sum.y + corner.y};
  const auto count = static_cast<double>(corners.size());
  return {sum.x / count, sum.y / count};
}

TEST(StaticStages, ShowStructuresWhereTheyHaveGone) {
  const Site site;
  Domain domain(site.spec);
  StaticStages walk = site.walk(domain);
  const auto shown = [&] {
    std::vector<Vector> positions;
    walk.show([&](Domain& model) {
      for (std::size_t b = 0; b < model.contact.bodies().size(); ++b) {
        const ElasticBody* const elastic = model.contact.elastic(b);
        positions.push_back(
            middle(elastic != nullptr ? elastic->surface().points() : model.contact.bodies()[b].outline()));
      }
    });
    return positions;
  };
  walk.next();
  const std::vector<Vector> placed = shown();
  walk.next(); // the load stands beside the elastic block
  const std::vector<Vector> loaded = shown();
  ASSERT_EQ(loaded.size(), 2u);
  EXPECT_NEAR(placed[1].x, 2.0, 1e-9);
  EXPECT_NEAR(placed[1].y, 0.5, 1e-9);
  EXPECT_LT(loaded[0].y, placed[0].y - 1e-5);
  EXPECT_NE(loaded[1].y, placed[1].y);
  while (!walk.are_over())
    walk.next();
  const std::vector<Vector> last = shown();
  ASSERT_EQ(last.size(), 1u);
  const Particles& block = domain.sets_of_body(0).front();
  double way = 0.0;
  for (std::size_t k = 0; k < block.size(); ++k)
    way += (block.y[k] - block.y_initial[k]) / static_cast<double>(block.size());
  EXPECT_NEAR(last[0].y - placed[0].y, way, 0.1 * std::abs(way));
}

/// What held up a trench while it was dug is gone at nodes that have no soil any more. A stage that fills it
/// again would begin with it.
TEST(StaticStages, LeaveNoForceWhereSoilHasGone) {
  constexpr double density = 1900.0;
  Spec spec = test_support::flat_ground(12.0, 4.0, 1.0, {density, 2e7, 0.3});
  spec.cut_at_edges = true;
  const std::vector<Region> whole{{0, rectangle(-6.0, -4.0, 6.0, -1.0)},
                                  {0, rectangle(-6.0, -1.0, -2.0, 0.0)},
                                  {0, rectangle(2.0, -1.0, 6.0, 0.0)},
                                  {0, rectangle(-2.0, -1.0, 2.0, 0.0)}};
  spec.regions = {whole[0], whole[1], whole[2]};
  const std::vector<StaticStage> stages{ConstructionSettings{settings, whole, {}, {}}};
  Domain domain(spec);
  StaticStages walk(domain, under_gravity, stages, [](std::size_t, long, double) {});
  walk.next();
  walk.next();
  SavedState saved;
  save(walk, saved);
  const double column = density * spec.gravity * 4.0; // of a metre's width, N/m
  for (const double force : saved.numbers("static.forces"))
    EXPECT_LT(std::abs(force), 1.1 * column);
}

/// The first step meets the bodies where a step after a sort would.
TEST(StaticStages, LeaveElasticBodiesTheSurfacesOfTheirParticles) {
  const Site site;
  Domain domain(site.spec);
  StaticStages stages = site.walk(domain);
  while (!stages.are_over())
    stages.next();
  stages.finish();
  const mesh::Rectangle before = domain.contact.bounds(0);
  domain.contact.follow_particles(domain);
  const mesh::Rectangle after = domain.contact.bounds(0);
  EXPECT_EQ(before.x_min, after.x_min);
  EXPECT_EQ(before.x_max, after.x_max);
  EXPECT_EQ(before.y_min, after.y_min);
  EXPECT_EQ(before.y_max, after.y_max);
  EXPECT_NE(after.x_max, -1.0); // it has moved
}

} // namespace
} // namespace tremolo::mpm_domain
