// Ground that changes around a lining in stages. Fill over level ground that comes or goes with the lining in
// place changes the stresses far from it by q = gamma t and q nu/(1 - nu), and its mean axial force by
//
//     dN_0 = -2 (1 - nu) (1 + nu/(1 - nu))/2 q R_o/(1 + 2 G R/(EA)) = -q R_o/(1 + 2 G R/(EA)),
//
// Lame's solution for a hole under stress from afar that a ring props. Water that rises around it by p_0
// changes its mean axial force by -p_0 R_o/(1 + 2 G R/(EA)) beside that.

#include "lining_state.hpp"

#include "mpm_domain/gravity/static_stages.hpp"
#include "tests/support/structure_scene.hpp"
#include "tests/support/wet_lining.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
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

/// What a lining bears after each stage.
struct Borne {
  double thrust; ///< N_0, N/m
  double upward; ///< what contact bears in a step, kg m/s per m
};

/// @param levels  of the water table: under gravity, and after each stage, m
std::vector<Borne> borne_at(const std::vector<double>& levels) {
  Spec spec = saturated_flat_ground(width, depth, 0.5, materials::Drainage::drained, ground.young);
  spec.linings = {concrete_lining(centre, 0.6)};
  spec.water->level = levels.back();
  std::vector<StaticStage> stages;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    GroundWater water = *spec.water;
    water.level = levels[k];
    stages.push_back(ConstructionSettings{
        {.ramp = 2.0, .residual = 1e-5, .max_time = 60.0, .undrained = {}}, spec.regions, {}, water});
  }
  Domain domain(spec);
  StaticStages walk(domain, {.residual = 1e-5}, stages, [](std::size_t, long, double) {});
  std::vector<Borne> borne;
  while (!walk.are_over()) {
    walk.next();
    walk.show([&](Domain& model) {
      const LiningBody& lining = model.linings.bodies().front();
      double upward = 0.0;
      for (const SegmentRows& of : lining.rows())
        upward += lining.contact().impulse(of).y;
      borne.push_back({mean_thrust(model), upward});
    });
  }
  return borne;
}

constexpr double deep = -22.0, low = -4.0, surface = 0.0, flood = 3.0; // levels, m

/// What a lining bears of the water whose table rises from `deep` over `low` to the surface.
void expect_rise(const std::vector<Borne>& borne) {
  // Grains weigh less by (1 - n) gamma of the water that they displace; free water above the ground presses
  // on no grain.
  const double unit_weight = heavy_fluid::water * heavy_fluid::gravity;
  const double shear = ground.young / (2.0 * (1.0 + ground.poisson));
  const double radius = outer / (1.0 + 2.0 * shear * ring_radius / ring_section.axial);
  const double rise = heavy_fluid::porosity * unit_weight * (surface - low) * radius;
  testing::Test::RecordProperty("rise", std::to_string((borne[1].thrust - borne[2].thrust) / rise));
  testing::Test::RecordProperty("upward", std::to_string(borne[1].upward / borne[0].upward));
  EXPECT_NEAR(borne[1].thrust - borne[2].thrust, rise, 0.02 * rise);
  const double weight = ring_section.mass * 2.0 * std::numbers::pi * ring_radius * heavy_fluid::gravity;
  const double lift = std::numbers::pi * outer * outer * unit_weight;
  // Where some of the soil is dry, steps are of one length.
  EXPECT_NEAR(borne[1].upward / borne[0].upward, 1.0 - lift / weight, 0.01);
}

TEST(StagedLining, BearsTheWaterThatRisesAroundIt) {
  expect_rise(borne_at({deep, low, surface}));
}

TEST(AcceptanceStagedLining, BearsTheWaterThatRisesAndFallsAroundIt) {
  const std::vector<Borne> borne = borne_at({deep, low, surface, flood, deep});
  expect_rise(borne);
  const double unit_weight = heavy_fluid::water * heavy_fluid::gravity;
  const double shear = ground.young / (2.0 * (1.0 + ground.poisson));
  const double radius = outer / (1.0 + 2.0 * shear * ring_radius / ring_section.axial);
  const double high_water = unit_weight * (flood - surface) * radius;
  RecordProperty("flood", std::to_string((borne[2].thrust - borne[3].thrust) / high_water));
  RecordProperty("back", std::to_string(borne[4].thrust / borne[0].thrust));
  EXPECT_NEAR(borne[2].thrust - borne[3].thrust, high_water, 0.02 * high_water);
  EXPECT_NEAR(borne[4].thrust, borne[0].thrust, 1e-3 * std::abs(borne[0].thrust));
  EXPECT_NEAR(borne[4].upward / borne[0].upward, 1.0, 0.01);
}

} // namespace
} // namespace tremolo::mpm_domain
