// Elastic bodies against others: a stack bears with the weight of all and goes down as one body of its
// outline does, bars exchange their velocities, blocks slide on each other with the friction between them,
// momentum is exact whatever meets, and a stack goes on from a checkpoint with the same bits.

#include "tests/support/saved_state.hpp"
#include "tests/support/structure_scene.hpp"
#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::quiet_ground;
using test_support::rectangle;
using test_support::StandingScene;
using test_support::structure;

constexpr double density = 1500.0; // kg/m3
constexpr double weight = 3.0 * 3.0 * density * 9.81;

/// Which blocks of a stack are elastic.
struct Kinds {
  const char* name;
  bool footing, stem, head;
};

void PrintTo(const Kinds& kinds, std::ostream* to) {
  *to << kinds.name;
}

/// A stack of 3 m by 3 m on soft ground: a footing, and on it a narrow and a wide block.
Spec stack(const Kinds& kinds, double young = 2e8) {
  Spec spec = flat_ground(18.0, 6.0, 0.5, {2000.0, 2e7, 0.3});
  const auto add = [&](const char* name, double half, double bottom, double top, bool elastic) {
    spec.structures.push_back(structure(rectangle(-half, bottom, half, top), density * 1.5 / half, 0.6));
    spec.structures.back().name = name;
    if (elastic)
      spec.structures.back().stiffness = Stiffness{young, 0.2};
  };
  add("footing", 1.5, 0.0, 1.0, kinds.footing);
  add("stem", 0.75, 1.0, 2.0, kinds.stem);
  add("head", 1.5, 2.0, 3.0, kinds.head);
  return spec;
}

class ElasticStack : public testing::TestWithParam<Kinds> {};

TEST_P(ElasticStack, BearsWithTheWeightOfAll) {
  StandingScene scene(stack(GetParam()), quiet_ground(), 1e-10);
  EXPECT_FALSE(scene.reactions.slipping);
  std::vector<Vector> before;
  for (const RigidBody& body : scene.domain.contact.bodies())
    before.push_back(body.centre());
  for (int k = 0; k < 5; ++k) {
    scene.run(0.1);
    // What a body gets from above and below bears its weight. Impulses at corners of two rigid bodies are
    // none of nodes.
    const auto by_corners = [&](std::size_t lower) {
      return !scene.domain.contact.is_elastic(lower) && !scene.domain.contact.is_elastic(lower + 1);
    };
    for (std::size_t b = 0; b < before.size(); ++b) {
      if ((b > 0 && by_corners(b - 1)) || (b < 2 && by_corners(b)))
        continue;
      const BodyForces forces = scene.domain.contact.forces(b);
      EXPECT_NEAR(forces.normal.force.y + forces.friction.force.y, weight / 3.0, 1e-4 * weight) << b;
    }
  }
  for (std::size_t b = 0; b < before.size(); ++b) {
    EXPECT_NEAR(scene.body(b).centre().x, before[b].x, 1e-6);
    EXPECT_NEAR(scene.body(b).centre().y, before[b].y, 1e-6);
    EXPECT_NEAR(scene.body(b).tilt(), 0.0, 1e-6);
  }
}

TEST_P(ElasticStack, PassesALoadOnToTheSoil) {
  constexpr double load = 60e3; // N/m
  Spec spec = stack(GetParam());
  spec.structure_loads = {{"head", {0.0, -load}}};
  const std::vector<StaticStage> stages{
      LoadSettings{{.ramp = 1.0, .residual = 1e-10, .max_time = 60.0}, 0, true}};
  StandingScene scene(spec, quiet_ground(), 1e-10, stages);
  for (int k = 0; k < 5; ++k) {
    scene.run(0.1);
    double on_soil = 0.0; // upward on structures, kg/s
    for (std::size_t b = 0; b < scene.domain.contact.bodies().size(); ++b)
      for (const ContactNode& c : scene.domain.contact.nodes(b))
        if (!c.key.against)
          on_soil += c.normal_impulse * c.normal.y + c.tangential_impulse * c.tangent().y;
    EXPECT_NEAR(on_soil / scene.stepper.kick(), weight + load, 1e-4 * weight);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ElasticStack,
                         testing::Values(Kinds{"three", true, true, true},
                                         Kinds{"rigid_head", true, true, false},
                                         Kinds{"rigid_footing", false, true, true},
                                         Kinds{"elastic_stem", false, true, false}),
                         [](const auto& of) { return std::string(of.param.name); });

/// Momentum and energy of all that is not soil.
struct Totals {
  double x = 0.0, y = 0.0, kinetic = 0.0, size = 0.0;
};

Totals totals(const Domain& domain) {
  Totals t;
  const auto add = [&](double mass, const Vector& v) {
    t.x += mass * v.x;
    t.y += mass * v.y;
    t.kinetic += 0.5 * mass * square(v);
    t.size += mass * std::sqrt(square(v));
  };
  for (std::size_t b = 0; b < domain.contact.bodies().size(); ++b)
    if (const RigidBody& body = domain.contact.bodies()[b]; !domain.contact.is_elastic(b))
      add(body.mass(), body.motion().velocity);
  for (const Particles& set : domain.body_sets())
    for (std::size_t k = 0; k < set.size(); ++k)
      add(set.mass[k], {set.vx[k], set.vy[k]});
  return t;
}

/// Saint-Venant: two equal bars of which one rests exchange their velocities, after 2 L/c.
TEST(ElasticNeighbours, BarsExchangeTheirVelocities) {
  constexpr double length = 20.0, speed = 0.1, young = 2e8, rho = 2000.0;
  std::vector<double> kept; // of the speed, m/s
  for (const double h : {1.0, 0.5}) {
    Spec spec = flat_ground(46.0, 2.0, h, {2000.0, 2e8, 0.2});
    spec.gravity = 0.0;
    spec.structures = {structure(rectangle(-length - 0.1, 3.0, -0.1, 5.0), rho, 0.0),
                       structure(rectangle(0.1, 3.0, length + 0.1, 5.0), rho, 0.0)};
    for (Structure& bar : spec.structures)
      bar.stiffness = Stiffness{young, 0.0};
    Domain domain(spec);
    test_support::set_motion(domain, 0, {{speed, 0.0}, 0.0});
    Stepper stepper(domain, 0.0, quiet_ground());
    const Totals start = totals(domain);
    const double contact = 2.0 * length / std::sqrt(young / rho);
    const auto go = [&](double until) {
      while (stepper.time() < until)
        stepper.step();
    };
    const double meets = 0.2 / speed;
    go(0.9 * meets);
    EXPECT_NEAR(domain.contact.bodies()[0].motion().velocity.x, speed, 1e-9);
    go(meets + 2.0 * contact);
    const double after = domain.contact.bodies()[1].motion().velocity.x;
    EXPECT_NEAR(domain.contact.bodies()[0].motion().velocity.x, speed - after, 1e-9);
    kept.push_back(speed - after);
    EXPECT_NEAR(after, speed, (h < 1.0 ? 0.03 : 0.07) * speed);
    EXPECT_NEAR(totals(domain).x, start.x, 1e-12 * start.size);
    EXPECT_NEAR(totals(domain).y, 0.0, 1e-12 * start.size);
    RecordProperty(h < 1.0 ? "passed_on_fine" : "passed_on_coarse", std::to_string(after / speed));
  }
  EXPECT_LT(kept[1], 0.6 * kept[0]); // of first order
}

/// Bodies that meet askew, away from the soil.
TEST(ElasticNeighbours, KeepMomentumAndGainNoEnergy) {
  for (const double friction : {0.0, 0.6})
    for (const bool both : {true, false}) {
      Spec spec = flat_ground(10.0, 2.0, 0.5, {2000.0, 1e8, 0.2});
      spec.gravity = 0.0;
      spec.structures = {
          structure(rectangle(-3.5, 3.0, -1.0, 6.0), 2000.0, friction),
          structure(test_support::turned(rectangle(0.0, 3.5, 1.5, 5.5), {0.75, 4.5}, 0.3), 500.0, friction)};
      spec.structures[1].stiffness = Stiffness{5e7, 0.2};
      if (both)
        spec.structures[0].stiffness = Stiffness{5e7, 0.2};
      Domain domain(spec);
      test_support::set_motion(domain, 1, {{-2.0, 0.3}, -0.2});
      test_support::set_motion(domain, 0, {{1.0, 0.1}, 0.05});
      Stepper stepper(domain, 0.0, quiet_ground());
      const Totals start = totals(domain);
      stepper.step(); // the ledger counts from rest
      const double unaccounted = domain.energy.residual();
      while (stepper.time() < 0.6)
        stepper.step();
      const Totals end = totals(domain);
      EXPECT_NEAR(end.x, start.x, 1e-12 * start.size);
      EXPECT_NEAR(end.y, start.y, 1e-12 * start.size);
      EXPECT_GT(domain.contact.bodies()[1].motion().velocity.x, 0.0); // it has bounced
      EXPECT_LT(end.kinetic, start.kinetic);
      const EnergyLedger& ledger = domain.energy;
      EXPECT_GE(ledger.friction, 0.0);
      EXPECT_NEAR(ledger.residual(), unaccounted, 0.01 * start.kinetic);
    }
}

/// The head of a stack that is pulled aside by 0.3 of its weight.
void expect_sliding(std::initializer_list<Kinds> stacks) {
  for (const Kinds& kinds : stacks)
    for (const double friction : {0.25, 0.35}) {
      Spec spec = stack(kinds, 2e9);
      spec.soils.front().law = materials::LinearElastic{{2000.0, 2e9, 0.3}}; // the footing hardly turns
      spec.structures[1].outline = rectangle(-1.5, 1.0, 1.5, 2.0);
      for (Structure& one : spec.structures)
        one.friction_between = friction;
      const double pull = 0.3 * weight / 3.0;
      spec.structure_loads = {{"head", {pull, 0.0}, Growth{0.0, 0.1}}};
      StandingScene scene(spec, quiet_ground(), 1e-9);
      const auto way = [&] { return scene.body(2).centre().x - scene.body(1).centre().x; };
      scene.run(0.2);
      const double before = way();
      const double speed = scene.body(2).motion().velocity.x - scene.body(1).motion().velocity.x;
      scene.run(0.2);
      if (friction > 0.3) {
        EXPECT_NEAR(way(), before, 1e-4) << kinds.name; // the stack leans a little
        continue;
      }
      const double exact = speed * 0.2 + 0.5 * 9.81 * (0.3 - friction) * 0.2 * 0.2;
      EXPECT_NEAR(way() - before, exact, 0.05 * exact) << kinds.name;
      EXPECT_GT(way() - before, 0.01);
    }
}

TEST(ElasticNeighbours, SlideWithTheFrictionBetweenThem) {
  expect_sliding({{"both", true, true, true}});
}

TEST(AcceptanceElasticNeighbours, SlideWhereOneOfThemIsRigid) {
  expect_sliding({{"head", false, false, true}});
}

/// A head that is taken off leaves what bears it as if it had never been there.
TEST(ElasticNeighbours, SpringBackWhenOneGoes) {
  for (const bool elastic : {true, false}) {
    const Kinds kinds{"", elastic, true, elastic};
    Spec spec = stack(kinds);
    const std::vector<Structure> all = spec.structures;
    const auto settle = [](const Domain& domain) {
      double way = 0.0;
      for (const Particles& set : domain.sets_of_soil())
        for (std::size_t k = 0; k < set.size(); ++k)
          way = std::min(way, set.syy[k]);
      return way;
    };
    spec.structures.pop_back();
    Domain without(spec);
    test::rest(without, {}, 1e-9);
    Domain after(spec);
    const std::vector<StaticStage> stages{test::construction(spec.regions, 1e-9, 2.0, false, all)};
    const Reactions reactions = test::rest(after, stages, 1e-9);
    EXPECT_FALSE(reactions.slipping);
    EXPECT_NEAR(settle(after), settle(without), 1e-4 * std::abs(settle(without))) << elastic;
  }
}

TEST(ElasticNeighbours, GoOnFromACheckpointWithTheSameBits) {
  Spec spec = stack({"", true, true, false});
  for (Structure& one : spec.structures)
    one.friction_between = 0.1;
  const auto shaking = [](long, double time, std::span<const Vector>, std::span<eq6::FreeField> field) {
    for (eq6::FreeField& face : field)
      face = {{0.5 * std::sin(20.0 * time), 0.2 * std::sin(15.0 * time)}, {}};
  };
  StandingScene whole(spec, shaking);
  whole.run(0.1);
  const test_support::SavedState saved = test_support::saved_state(whole.domain, whole.stepper);
  const double slid = whole.domain.energy.friction;
  whole.run(0.1);
  EXPECT_GT(whole.domain.energy.friction, slid);

  spec.threads = 1;
  StandingScene resumed(spec, shaking);
  test_support::restore_state(saved, resumed.domain, resumed.stepper);
  resumed.run(0.1);
  expect_same(test_support::saved_state(whole.domain, whole.stepper),
              test_support::saved_state(resumed.domain, resumed.stepper));
}

} // namespace
} // namespace tremolo::mpm_domain
