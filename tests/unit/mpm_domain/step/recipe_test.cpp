// A step has the passes that its scene calls for, by phase, and no others.

#include "mpm_domain/step/recipe.hpp"
#include "tests/support/box_models.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tremolo {
namespace {

using materials::Drainage;
using mpm_domain::Domain;
using mpm_domain::Pass;
using mpm_domain::Phase;
using mpm_domain::recipe;
using mpm_domain::Spec;
using mpm_domain::StepOrder;
using Names = std::vector<std::string>;

/// The names of the passes, in order of phase; passes without a name count for the one before. The boundary
/// reads the soil at its faces, and ranks the sums there, when all is on the grid.
Names names_of(const std::vector<Pass>& passes) {
  EXPECT_TRUE(std::ranges::is_sorted(passes, {}, &Pass::phase));
  EXPECT_EQ(std::ranges::find(passes, Phase::scatter, &Pass::phase)->name, "particles to grid");
  Names names;
  for (const Pass& pass : passes)
    if (!pass.name.empty())
      names.push_back(pass.name);
  return names;
}

Names names_of(const Spec& spec) {
  Domain domain(spec);
  return names_of(recipe(domain, test_support::quiet_ground()));
}

Spec box(StepOrder order = StepOrder::musl) {
  Spec spec = test_support::elastic_box(6.0, 4.0, 1.0);
  spec.scheme.order = order;
  return spec;
}

Spec wet_box(Drainage drainage, StepOrder order = StepOrder::musl) {
  Spec spec = box(order);
  test_support::add_water(spec, drainage);
  spec.water->level = 0.0;
  return spec;
}

TEST(Recipe, OfDrySoilIsScatterUpdateGather) {
  EXPECT_EQ(names_of(box(StepOrder::usl)),
            (Names{"time step", "sort", "particles to grid", "grid velocities", "boundary exchange",
                   "boundary tractions", "grid update", "grid to particles, stress", "accelerations"}));
  EXPECT_EQ(names_of(box()),
            (Names{"time step", "sort", "particles to grid", "grid velocities", "boundary exchange",
                   "boundary tractions", "grid update", "grid to particles", "velocities to grid again",
                   "remapped velocities", "strain and stress", "accelerations"}));
}

TEST(Recipe, OfAFreeBodyHasNoBoundary) {
  Domain domain(box());
  const auto none = test_support::no_traction(domain);
  EXPECT_EQ(
      names_of(recipe(domain, none)),
      (Names{"time step", "sort", "particles to grid", "grid velocities", "grid update", "grid to particles",
             "velocities to grid again", "remapped velocities", "strain and stress", "accelerations"}));
}

TEST(Recipe, OfWetSoilFindsPressuresBeforeStresses) {
  EXPECT_EQ(names_of(wet_box(Drainage::undrained)),
            (Names{"time step", "sort", "particles to grid", "grid velocities", "boundary exchange",
                   "boundary tractions", "grid update", "grid to particles", "velocities to grid again",
                   "remapped velocities", "pore pressure", "weight under water", "strain and stress",
                   "accelerations"}));
  EXPECT_EQ(names_of(wet_box(Drainage::undrained, StepOrder::usl)),
            (Names{"time step", "sort", "particles to grid", "grid velocities", "boundary exchange",
                   "boundary tractions", "grid update", "pore pressure", "weight under water",
                   "grid to particles, stress", "accelerations"}));
  const Names drained = names_of(wet_box(Drainage::drained));
  EXPECT_EQ(std::ranges::count(drained, "pore pressure"), 0);
  EXPECT_EQ(std::ranges::count(drained, "weight under water"), 1);
}

TEST(Recipe, OfFlowingWaterTransfersBothPhasesTogether) {
  EXPECT_EQ(names_of(wet_box(Drainage::coupled)),
            (Names{"time step", "sort", "particles to grid", "grid velocities", "boundary exchange",
                   "boundary tractions", "grid update", "grid to particles and back", "remapped velocities",
                   "pore pressure", "weight under water", "strain and stress", "accelerations"}));
}

/// Walls on the flow are closed after the tractions and open again when the work of the update is booked.
TEST(Recipe, OfFlowingWaterClosesWallsForTheUpdateAlone) {
  const auto unnamed = [](const Spec& spec, Phase phase) {
    Domain domain(spec);
    return std::ranges::count_if(recipe(domain, test_support::quiet_ground()),
                                 [&](const Pass& pass) { return pass.phase == phase && pass.name.empty(); });
  };
  const Spec flowing = wet_box(Drainage::coupled);
  const Spec still = wet_box(Drainage::undrained);
  EXPECT_EQ(unnamed(flowing, Phase::forces), unnamed(still, Phase::forces) + 1);
  EXPECT_EQ(unnamed(flowing, Phase::books), unnamed(still, Phase::books) + 1);
}

TEST(Recipe, OfStructuresMeetsThemAfterTheUpdateAndMovesThemLast) {
  Spec spec = test_support::flat_ground(8.0, 4.0, 1.0, {1700.0, 40e6, 0.28});
  spec.structures = {test_support::structure(test_support::rectangle(-1.0, 0.0, 1.0, 2.0), 2400.0, 0.4)};
  EXPECT_EQ(names_of(spec), (Names{"time step", "sort", "particles to grid", "grid velocities",
                                   "boundary exchange", "boundary tractions", "grid update", "contact",
                                   "grid to particles", "velocities to grid again", "remapped velocities",
                                   "strain and stress", "bodies", "accelerations"}));
}

TEST(Recipe, OfPropsPullsWithTheForcesAndFollowsTheBodies) {
  Spec spec = test_support::flat_ground(8.0, 4.0, 1.0, {2000.0, 2e8, 0.2});
  spec.structures = {test_support::structure(test_support::rectangle(-2.0, 0.0, 2.0, 3.0), 2000.0, 0.5)};
  mpm_domain::Prop prop;
  prop.from = {"block", {0.0, 1.0}};
  prop.to = {"", {0.0, -2.0}};
  prop.stiffness = 1e6;
  spec.props = {prop};
  const Names names = names_of(spec);
  const auto at = [&](const char* name) { return std::ranges::find(names, name); };
  ASSERT_NE(at("props"), names.end());
  EXPECT_LT(at("boundary exchange"), at("props"));
  EXPECT_LT(at("props"), at("grid update"));
  spec.props.clear();
  const Names without = names_of(spec);
  EXPECT_EQ(std::ranges::find(without, "props"), without.end());
}

TEST(Recipe, OfReducedDispersionSharpensForcesAndVelocities) {
  Spec spec = box();
  spec.scheme.dispersion = mpm_domain::Dispersion::reduced;
  EXPECT_EQ(names_of(spec),
            (Names{"time step", "sort", "particles to grid", "sharpened forces", "grid velocities",
                   "boundary exchange", "boundary tractions", "grid update", "grid to particles",
                   "velocities to grid again", "remapped velocities", "sharpened velocities",
                   "strain and stress", "accelerations"}));
}

TEST(Recipe, OfARigidBaseHasInertiaInThePlaceOfTractions) {
  Spec spec = box();
  test_support::put_into_container(spec);
  EXPECT_EQ(names_of(spec),
            (Names{"time step", "sort", "particles to grid", "grid velocities", "boundary exchange",
                   "inertia", "grid update", "grid to particles", "velocities to grid again",
                   "remapped velocities", "strain and stress", "accelerations"}));
}

TEST(Recipe, OfMatchedLayersStepsThemBeforeTheTractions) {
  Spec spec = box();
  spec.layer_cells = 3;
  test_support::add_layers(spec);
  EXPECT_EQ(names_of(spec),
            (Names{"time step", "sort", "particles to grid", "grid velocities", "boundary exchange",
                   "matched layers", "boundary tractions", "grid update", "grid to particles",
                   "velocities to grid again", "remapped velocities", "strain and stress", "accelerations"}));
}

/// Clocks are lists that the same passes walk.
TEST(Recipe, OfSeveralClocksIsThatOfOne) {
  Spec spec = box();
  spec.refine = {{{2.0, -2.0, 4.0, 0.0}, 1}};
  spec.scheme.subcycle = true;
  EXPECT_EQ(names_of(spec), names_of(box()));
}

} // namespace
} // namespace tremolo
