// Hard cases 28 to 32: structures that rest, are far heavier or lighter than the soil, cut into it with a
// corner, collide with soil between them, and come to the surface.

#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "tests/support/conservation_monitor.hpp"
#include "tests/support/structure_scene.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double gravity = 9.81; // m/s2
constexpr double h = 0.5;        // of cells, m

/// Sand that bears no tension, dry or saturated.
Spec sand(double width, double depth, materials::Drainage drainage, bool wet) {
  const materials::PoreSpace pores{
      .porosity = 0.44, .grain_density = 2650.0, .permeability = 1e-4, .drainage = drainage};
  const materials::PoreFluid fluid{.density = 1000.0, .bulk_modulus = 2e7};
  materials::MohrCoulomb law;
  law.elastic = {materials::saturated_density(pores, fluid), 2e7, 0.3};
  law.friction_peak = law.friction_residual = 0.58;
  Spec spec = flat_ground(width, depth, h, law.elastic);
  spec.soils.front().law = law;
  spec.sides = Sides::periodic;
  spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
  if (wet) {
    spec.water = GroundWater{0.0, fluid};
    spec.soils.front().pores = pores;
  }
  return spec;
}

/// Brings a scene to rest, then changes what `prepare` says.
MakeScene resting(const Spec& spec, const std::function<void(Domain&)>& prepare = {}) {
  return [=](int threads) {
    Spec own = spec;
    own.threads = threads;
    auto domain = std::make_unique<Domain>(own);
    if (own.gravity > 0.0)
      replace_constraints(*domain, relax_under_gravity(*domain, {.residual = 1e-9}, [](long, double) {}));
    if (prepare)
      prepare(*domain);
    return Scene{std::move(domain), quiet_ground()};
  };
}

const RigidBody& body(const Domain& domain, std::size_t which = 0) {
  return domain.contact.bodies()[which];
}

double upward(const BodyForces& forces) {
  return forces.normal.force.y + forces.friction.force.y + forces.water.force.y;
}

/// How deep the places of soil's particles lie in the first body, at most, over half the half side.
double deepest(const Domain& domain) {
  const ElasticBody* const elastic = domain.contact.elastic(0);
  const BodySurface& surface = elastic != nullptr ? elastic->surface() : body(domain).surface();
  double most = 0.0;
  for (const Particles& p : domain.sets_of_soil())
    for (std::size_t k = 0; k < p.size(); ++k)
      most = std::max(most, -surface.nearest({p.x[k], p.y[k]}).distance / (0.5 * p.half_size));
  return most;
}

/// 28: a block at rest, in acceptance for a minute.
struct Resting {
  const char* name;
  bool wet;
  bool elastic;
};

class HardCase28BlockAtRest : public testing::TestWithParam<Resting> {};

void expect_rest(const Resting& of, std::size_t seconds) {
  Spec spec = sand(12.0, 4.0, materials::Drainage::undrained, of.wet);
  spec.structures = {structure(rectangle(-1.5, -0.5, 1.5, 1.5), 2000.0, 0.4)};
  if (of.elastic)
    spec.structures.front().stiffness = Stiffness{2e7, 0.2};
  const auto time = static_cast<double>(seconds);
  std::vector<double> forces; // once a second
  const Scene scene = run_monitored(resting(spec), {.speed = 1e-3, .energy_floor = 1.0}, at_time(time),
                                    [&](const Domain& domain, const Stepper& stepper) {
                                      if (stepper.time() < static_cast<double>(forces.size() + 1))
                                        return;
                                      const BodyForces now = domain.contact.forces(0);
                                      forces.push_back(upward(now) / -now.weight.force.y);
                                    });
  ASSERT_EQ(forces.size(), seconds);
  const double mean = std::accumulate(forces.begin(), forces.end(), 0.0) / time;
  double deviation = 0.0;
  for (const double force : forces)
    deviation += (force - mean) * (force - mean) / time;
  bounded("scatter of the contact force, over the weight", std::sqrt(deviation), 0.02);
  bounded("error of the contact force, over the weight", std::abs(mean - 1.0), 0.005);
  const RigidBody& block = body(*scene.domain);
  const Vector moved{block.centre().x - block.start().x, block.centre().y - block.start().y};
  bounded("drift", std::hypot(moved.x, moved.y) / time, 1e-3 * h, "m/s");
}

TEST_P(HardCase28BlockAtRest, ABlockAtRest) {
  expect_rest(GetParam(), 20);
}

TEST_P(HardCase28BlockAtRest, AcceptanceForAMinute) {
  expect_rest(GetParam(), 60);
}

INSTANTIATE_TEST_SUITE_P(Soils, HardCase28BlockAtRest,
                         testing::Values(Resting{"dry", false, false}, Resting{"saturated", true, false},
                                         Resting{"elastic", false, true}),
                         [](const auto& block) { return std::string(block.param.name); });

/// 29: blocks from a thousandth of the soil's density to a thousand times that. Waves in elastic ones are as
/// fast as the soil's.
struct Weight {
  double ratio; ///< of densities
  bool elastic;

  friend void PrintTo(const Weight& weight, std::ostream* out) {
    *out << (weight.elastic ? "elastic, " : "rigid, ") << weight.ratio;
  }
};

class HardCase29BlockOfAnotherDensity : public testing::TestWithParam<Weight> {};

TEST_P(HardCase29BlockOfAnotherDensity, ABlockOfAnotherDensity) {
  Spec spec = sand(8.0, 3.0, materials::Drainage::drained, false);
  spec.gravity = 0.0;
  spec.sides = Sides::free_field;
  spec.soils.front().law = materials::LinearElastic{{2000.0, 1e9, 0.2}};
  spec.structures = {structure(rectangle(-1.0, -0.25, 1.0, 1.0), 2000.0 * GetParam().ratio, 0.5)};
  if (GetParam().elastic)
    spec.structures.front().stiffness = Stiffness{1e9 * GetParam().ratio, 0.2};
  double given = 0.0;
  const auto thrown = [&](Domain& domain) { // into the soil, aslant and spinning
    constexpr RigidMotion motion{{0.5, -0.5}, 0.2};
    set_motion(domain, 0, motion);
    RigidBody moving = body(domain);
    moving.set_motion(motion);
    given = moving.kinetic_energy();
  };
  // Impulses are booked on the mean of the velocities before and after the step, not on that of the trial
  // and the common velocity, on which no impulse gains (rigid_contact_test.cpp): steps may give a little
  // back.
  double worst = 0.0;
  double dissipated = 0.0;
  run_monitored(resting(spec, thrown), {.speed = 2.0}, at_time(0.05),
                [&](const Domain& domain, const Stepper&) {
                  const double now = domain.energy.friction + domain.energy.impact;
                  worst = std::max(worst, dissipated - now);
                  dissipated = now;
                });
  bounded("energy given back by contact in a step, over that given", worst / given, 1e-3);
  bounded("energy gained by contact in all, over that given", -dissipated / given, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Ratios, HardCase29BlockOfAnotherDensity,
                         testing::Values(Weight{1e-3, false}, Weight{1e-1, false}, Weight{1.0, false},
                                         Weight{1e1, false}, Weight{1e3, false}));
INSTANTIATE_TEST_SUITE_P(ElasticRatios, HardCase29BlockOfAnotherDensity,
                         testing::Values(Weight{1e-3, true}, Weight{1e-1, true}, Weight{1.0, true},
                                         Weight{1e1, true}, Weight{1e3, true}));

/// 30: a building toe at 15 degrees cuts into the sand.
class HardCase30CuttingCorner : public testing::TestWithParam<bool> {};

TEST_P(HardCase30CuttingCorner, ACornerCutsIn) {
  const double lean = 15.0 * std::acos(-1.0) / 180.0;
  Spec spec = sand(12.0, 4.0, materials::Drainage::drained, false);
  spec.structures = {// on its left toe
                     structure(turned(rectangle(-1.0, 0.0, 1.0, 6.0), {-1.0, 0.0}, lean), 800.0, 0.5)};
  if (GetParam())
    spec.structures.front().stiffness = Stiffness{2e7, 0.2};
  const auto leaning = [&](int threads) { // it cannot come to rest first
    Spec own = spec;
    own.threads = threads;
    auto domain = std::make_unique<Domain>(own);
    set_rest_stress(domain->sets, own);
    return Scene{std::move(domain), quiet_ground()};
  };
  double spike = 0.0;
  double inside = 0.0;
  run_monitored(leaning, {.speed = 5.0}, at_time(1.5), [&](const Domain& domain, const Stepper&) {
    const double weight = body(domain).mass() * gravity;
    spike = std::max(spike, upward(domain.contact.forces(0)) / weight);
    inside = std::max(inside, deepest(domain));
  });
  bounded("depth of particles in the body, over half their half side", inside, 1.0 + 1e-9);
  bounded("largest contact force, over the weight", spike, 5.0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, HardCase30CuttingCorner, testing::Bool(),
                         [](const auto& elastic) { return elastic.param ? "elastic" : "rigid"; });

/// A tall building and a low one with soil at their feet.
Spec two_buildings() {
  Spec spec = sand(16.0, 4.0, materials::Drainage::drained, false);
  spec.structures = {structure(rectangle(-4.0, -0.5, -0.75, 8.0), 500.0, 0.4),
                     structure(rectangle(0.75, -0.5, 4.0, 4.0), 500.0, 0.4)};
  return spec;
}

/// The tall one topples towards the low one, about its right toe; its roof moves with 10.9 m/s.
/// @param speed  bound on what is fastest, m/s; points of rigid bodies do not count
/// @param overlap_bound  in cells
void expect_collision(const Spec& spec, double speed, double end, double overlap_bound) {
  const auto toppling = [](Domain& domain) {
    constexpr double spin = -1.2;
    const Vector tall = body(domain, 0).centre();
    set_motion(domain, 0, {{-spin * (tall.y + 0.5), spin * (tall.x + 0.75)}, spin});
  };
  double deepest_corner = 0.0;
  double met = 0.0;
  run_monitored(resting(spec, toppling), {.speed = speed}, at_time(end),
                [&](const Domain& domain, const Stepper&) {
                  deepest_corner = std::max(deepest_corner, overlap(body(domain, 0), body(domain, 1)));
                  met = std::max(met, std::abs(body(domain, 1).motion().spin));
                });
  reaches("spin of the low building", met, 1e-3, "rad/s");
  bounded("overlap of the buildings, in cells", deepest_corner / h, overlap_bound);
}

/// 31: two buildings lean on each other with soil at their feet.
TEST(HardCase31Collision, TwoBuildingsCollide) {
  expect_collision(two_buildings(), 6.0, 2.0, 0.2);
}

/// 31 with elastic buildings, and with one that is: the tall one falls onto the low one and leans on it.
class HardCase31Pounding : public testing::TestWithParam<bool> {};

/// @param both  buildings are elastic
void expect_pounding(bool both, double end) {
  Spec spec = two_buildings();
  spec.structures.front().stiffness = Stiffness{2e7, 0.2};
  if (both)
    spec.structures.back().stiffness = Stiffness{2e7, 0.2};
  expect_collision(spec, 12.0, end, 0.5);
}

TEST_P(HardCase31Pounding, ElasticBuildingsMeetAndDoNotOverlap) {
  expect_pounding(GetParam(), 0.4);
}

TEST_P(HardCase31Pounding, AcceptanceUntilTheyLean) {
  expect_pounding(GetParam(), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, HardCase31Pounding, testing::Bool(),
                         [](const auto& both) { return both.param ? "both" : "one"; });

/// 32: a light body comes up through liquefied soil and breaks the surface.
struct Rising {
  bool elastic;
  double end; ///< s

  friend void PrintTo(const Rising& body, std::ostream* out) {
    *out << (body.elastic ? "elastic" : "rigid") << " until " << body.end << " s";
  }
};

class HardCase32LightBody : public testing::TestWithParam<Rising> {};

void expect_surfacing(bool elastic, double end) {
  Spec spec = sand(12.0, 6.0, materials::Drainage::undrained, true);
  spec.soils.front().damping_time = 2e-4;
  spec.water->fluid.bulk_modulus = 1e9; // far stiffer than the grains, or these would take up stress again
  spec.structures = {structure(circle({0.0, -1.75}, 1.25, 48), 300.0, 0.4)};
  if (elastic)
    spec.structures.front().stiffness = Stiffness{2e7, 0.2};
  const Scene scene = run_monitored(resting(spec, liquefy), {.speed = 5.0}, at_time(end));
  reaches("height of its crown above the ground of the start", body(*scene.domain).surface().bounds().y_max,
          0.1, "m");
  bounded("depth of particles in the body, over half their half side", deepest(*scene.domain), 1.0 + 1e-9);
}

TEST_P(HardCase32LightBody, ALightBodySurfaces) {
  expect_surfacing(GetParam().elastic, GetParam().end);
}

std::string name_of(const testing::TestParamInfo<Rising>& body) {
  return body.param.elastic ? "elastic" : "rigid";
}

INSTANTIATE_TEST_SUITE_P(Bodies, HardCase32LightBody, testing::Values(Rising{false, 2.5}), name_of);

INSTANTIATE_TEST_SUITE_P(AcceptanceBodies, HardCase32LightBody,
                         testing::Values(Rising{false, 5.0}, Rising{true, 5.0}), name_of);

} // namespace
} // namespace tremolo
