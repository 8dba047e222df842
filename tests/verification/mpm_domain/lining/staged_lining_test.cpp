// Ground that changes around a lining in stages. Fill over level ground that comes or goes with the lining in
// place changes the stresses far from it by q = gamma t and q nu/(1 - nu), and its mean axial force by
//
//     dN_0 = -2 (1 - nu) (1 + nu/(1 - nu))/2 q R_o/(1 + 2 G R/(EA)) = -q R_o/(1 + 2 G R/(EA)),
//
// Lame's solution for a hole under stress from afar that a ring props.

#include "lining_state.hpp"

#include "tests/support/structure_scene.hpp"
#include "tests/support/wet_lining.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

constexpr Vector centre{0.13, -12.21};
constexpr materials::Elasticity ground{1900.0, 5e7, 0.3};
constexpr double width = 30.0, depth = 24.0, fill = 2.0; // m
constexpr double outer = ring_radius + 0.5 * ring_thickness;

Spec tunnel(bool filled) {
  Spec spec = flat_ground(width, depth, 0.5, ground);
  spec.box.y_max = fill;
  if (filled)
    spec.regions.push_back({0, rectangle(-0.5 * width, 0.0, 0.5 * width, fill)});
  spec.linings = {concrete_lining(centre, 0.6)};
  return spec;
}

double mean_thrust(const Domain& domain) {
  return mean_thrust(domain.linings.bodies().front().beam());
}

double thrust_after(const Spec& spec, const std::vector<Region>& before) {
  const std::vector<StaticStage> stages{ConstructionSettings{
      {.ramp = 2.0, .residual = 1e-4, .max_time = 60.0, .undrained = {}}, before, {}, {}}};
  const StandingScene scene(spec, quiet_ground(), 1e-4, stages);
  EXPECT_FALSE(scene.reactions.slipping);
  return mean_thrust(scene.domain);
}

TEST(StagedLining, IsLoadedByFillAndRelievedByItsRemoval) {
  const double shear = ground.young / (2.0 * (1.0 + ground.poisson));
  const double change =
      -ground.density * 9.81 * fill * outer / (1.0 + 2.0 * shear * ring_radius / ring_section.axial);
  const Spec bare = tunnel(false);
  const Spec filled = tunnel(true);
  const double without = mean_thrust(StandingScene(bare, quiet_ground(), 1e-4).domain);
  const double with = mean_thrust(StandingScene(filled, quiet_ground(), 1e-4).domain);
  const double placed = thrust_after(filled, bare.regions) - without;
  const double removed = thrust_after(bare, filled.regions) - with;
  RecordProperty("placed", std::to_string(placed / change));
  RecordProperty("removed", std::to_string(-removed / change));
  EXPECT_NEAR(placed, change, 0.02 * std::abs(change));
  EXPECT_NEAR(removed, -change, 0.02 * std::abs(change));
}

/// What a load on the whole surface changes: N_0, and the amplitude of cos 2 theta of M.
struct Change {
  double thrust, moment;
};

Change change_by_load(double pressure, bool undrained) {
  Spec spec = saturated_flat_ground(width, depth, 0.5, materials::Drainage::undrained, ground.young);
  spec.water->fluid.bulk_modulus = 2e8;
  spec.linings = {concrete_lining(centre, 0.6)};
  spec.loads = {{-0.5 * width, 0.5 * width, 0.0}};
  Change change{};
  for (const double share : {-1.0, 1.0}) {
    spec.loads.front().pressure = share > 0.0 ? pressure : 0.0;
    Domain domain(spec);
    const std::vector<StaticStage> stages{
        LoadSettings{{.ramp = 2.0, .residual = 1e-4, .max_time = 60.0, .undrained = {undrained}}, 0}};
    bring_to_rest(domain, {.residual = 1e-4}, stages, [](std::size_t, long, double) {});
    const Beam& beam = domain.linings.bodies().front().beam();
    const auto count = static_cast<double>(beam.elements().size());
    for (std::size_t e = 0; e < beam.elements().size(); ++e)
      change.moment += share * 2.0 / count * beam.forces(e).moment *
                       std::cos(4.0 * std::numbers::pi * (static_cast<double>(e) + 0.5) / count);
    change.thrust += share * mean_thrust(domain);
  }
  return change;
}

TEST(AcceptanceStagedLining, IsHardlyBentByALoadThatWaterBears) {
  constexpr double pressure = 40e3;
  const double shear = ground.young / (2.0 * (1.0 + ground.poisson));
  const double thrust = -pressure * outer / (1.0 + 2.0 * shear * ring_radius / ring_section.axial);
  const Change drained = change_by_load(pressure, false);
  const Change undrained = change_by_load(pressure, true);
  // Stress of level ground from the side, over that from above, is nu/(1 - nu): 0.43 without water, and 0.93
  // with what K_f/n adds to its stiffness.
  RecordProperty("drained", std::to_string(drained.thrust / thrust));
  RecordProperty("undrained", std::to_string(undrained.thrust / thrust));
  RecordProperty("moments", std::to_string(undrained.moment / drained.moment));
  EXPECT_NEAR(drained.thrust, thrust, 0.02 * std::abs(thrust));
  EXPECT_NEAR(undrained.thrust, thrust, 0.02 * std::abs(thrust));
  EXPECT_GT(undrained.moment / drained.moment, 0.05);
  EXPECT_LT(undrained.moment / drained.moment, 0.2);
}

TEST(StagedLining, DoesNotBearWaterThatChanges) {
  Spec spec = saturated_flat_ground(20.0, 12.0, 0.5, materials::Drainage::drained, 5e7);
  spec.linings = {concrete_lining({0.13, -6.21}, 0.6)};
  GroundWater before = *spec.water;
  before.level = -1.0;
  const std::vector<StaticStage> stages{ConstructionSettings{
      {.ramp = 2.0, .residual = 1e-3, .max_time = 60.0, .undrained = {}}, spec.regions, {}, before}};
  Domain domain(spec);
  EXPECT_THROW(bring_to_rest(domain, {.residual = 1e-3}, stages, [](std::size_t, long, double) {}),
               std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
