// Hard cases 40 to 42: rigid structures that move far over the ground, in air and under water. A block slides
// down a long slope, one topples and comes to rest on its side, one is thrown by shaking and lands.
//
// Under water the ground is drained: its pressure and that around the block stay those of water at rest, so
// that the closed forms hold with the effective weight, M g (1 - rho_w/rho). Water in front of a body is not
// there: it has no added mass, and nothing brakes it. Ground that cannot drain bears a part of a load that
// comes onto it by its water, without friction, and holds a body that leaves it by suction (the last case).

#include "tests/support/conservation_monitor.hpp"
#include "tests/support/structure_scene.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double gravity = 9.81; // m/s2
constexpr double h = 0.5;        // of cells, m
constexpr double water_density = 1000.0, block_density = 2000.0;

/// Stiff elastic ground, above or below a water table.
Spec ground(double width, double depth, bool wet, double level,
            materials::Drainage drainage = materials::Drainage::drained) {
  const materials::PoreSpace pores{
      .porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-4, .drainage = drainage};
  const materials::PoreFluid fluid{.density = water_density, .bulk_modulus = 2e8};
  Spec spec =
      flat_ground(width, depth, h, {wet ? materials::saturated_density(pores, fluid) : 2000.0, 2e8, 0.2});
  spec.threads = 1;
  if (wet) {
    spec.water = GroundWater{level, fluid};
    spec.soils.front().pores = pores;
  }
  return spec;
}

/// Brings a scene to rest.
MakeScene resting(const Spec& spec, FreeFieldSource source = quiet_ground()) {
  return [=](int threads) {
    Spec own = spec;
    own.threads = threads;
    auto domain = std::make_unique<Domain>(own);
    replace_constraints(*domain, relax_under_gravity(*domain, {.residual = 1e-6}, [](long, double) {}));
    return Scene{std::move(domain), source};
  };
}

const RigidBody& body(const Domain& domain) {
  return domain.contact.bodies().front();
}

/// 40: twenty cells down a slope of 20 degrees, in air or in water.
class HardCase40SlidingBlock : public testing::TestWithParam<bool> {};

TEST_P(HardCase40SlidingBlock, ABlockSlidesDownALongSlope) {
  constexpr double angle = 20.0 * std::numbers::pi / 180.0, half = 8.0, shelf = 3.0, friction = 0.1; // m
  constexpr double way = 20.0 * h, start = 5.5;                                                      // m
  const double rise = half * std::tan(angle);
  Spec spec = ground(2.0 * (half + shelf), 6.0, GetParam(), 6.0);
  spec.box.y_max = 5.0;
  spec.regions.front().polygon = {{-half - shelf, -6.0}, {half + shelf, -6.0}, {half + shelf, rise},
                                  {half, rise},          {-half, -rise},       {-half - shelf, -rise}};
  spec.structures = {structure(turned(rectangle(start - 1.0, 0.0, start + 1.0, 1.0), {0.0, 0.0}, angle),
                               block_density, friction)};
  const double pull = GetParam() ? gravity * (1.0 - water_density / block_density) : gravity;
  const double exact = pull * (std::sin(angle) - friction * std::cos(angle));
  double slid = 0.0;
  double off = 0.0; // the slope, m
  double error = 0.0;
  run_monitored(
      resting(spec), {.speed = 8.0, .energy_floor = 1.0}, [&](const Stepper&) { return slid >= way; },
      [&](const Domain& domain, const Stepper& stepper) {
        const RigidBody& block = body(domain);
        const Vector moved{block.centre().x - block.start().x, block.centre().y - block.start().y};
        slid = -(moved.x * std::cos(angle) + moved.y * std::sin(angle));
        off = std::max(off, std::abs(moved.y * std::cos(angle) - moved.x * std::sin(angle)));
        error = std::abs(slid / (0.5 * exact * stepper.time() * stepper.time()) - 1.0);
        ASSERT_LT(stepper.time(), 20.0);
      });
  bounded("error of the way, over that of the closed form", error, 0.02);
  bounded("distance from the slope, in cells", off / h, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Slides, HardCase40SlidingBlock, testing::Bool(),
                         [](const auto& wet) { return std::string(wet.param ? "in_water" : "in_air"); });

/// 41: a slender block, a little beyond its balance on its right toe, falls on its side.
class HardCase41ToppledBlock : public testing::TestWithParam<bool> {};

TEST_P(HardCase41ToppledBlock, ABlockTopplesAndComesToRest) {
  constexpr double width = 1.5, height = 4.5; // m
  const double lean = 1.1 * std::atan2(width, height);
  Spec spec = ground(20.0, 4.0, GetParam(), 6.0);
  spec.structures = {structure(rectangle(-width, 0.0, 0.0, height), block_density, 0.8)};
  const auto leaning = [=](int threads) {
    Scene scene = resting(spec)(threads);
    const RigidBody& block = body(*scene.domain);
    const Vector arm = block.centre(); // from its toe
    const double c = std::cos(lean);
    const double s = std::sin(lean);
    set_bodies(*scene.domain, {{c * arm.x + s * arm.y, c * arm.y - s * arm.x, -lean, 0.0, 0.0, 0.0}});
    return scene;
  };
  const Scene scene = run_monitored(leaning, {.speed = 6.0, .energy_floor = 1.0}, at_time(8.0));
  const RigidBody& block = body(*scene.domain);
  bounded("tilt from lying on its side", std::abs(block.tilt() + 0.5 * std::numbers::pi), 0.01, "rad");
  bounded("height of its centre over half its width, in cells", std::abs(block.centre().y - 0.5 * width) / h,
          0.05);
  bounded("speed of its corners", scene.domain->contact.fastest_point(), 0.02, "m/s");
}

INSTANTIATE_TEST_SUITE_P(Topples, HardCase41ToppledBlock, testing::Bool(),
                         [](const auto& wet) { return std::string(wet.param ? "in_water" : "in_air"); });

/// Ground that heaves and stops, m/s over time (s).
FreeFieldSource heaving() {
  return [](long, double t, std::span<const Vector>, std::span<eq6::FreeField> field) {
    constexpr double velocity = 3.0, heave = 0.3; // m/s, s
    const bool moves = t > 0.0 && t < 2.0 * heave;
    const double v = moves ? velocity * std::sin(std::numbers::pi * t / heave) : 0.0;
    for (eq6::FreeField& face : field)
      face = {{0.0, v}, {}};
  };
}

/// 42: it throws a block up, which flies as a stone does, and lands.
class HardCase42ThrownBlock : public testing::TestWithParam<bool> {};

TEST_P(HardCase42ThrownBlock, ABlockIsThrownAndLands) {
  Spec spec = ground(12.0, 4.0, GetParam(), 6.0);
  spec.structures = {structure(rectangle(-1.0, 0.0, 1.0, 1.0), block_density, 0.5)};
  const double pull = GetParam() ? gravity * (1.0 - water_density / block_density) : gravity;
  struct {
    double time, height, velocity; // as it leaves the ground, s, m, m/s
  } launch{};
  bool flies = false;
  double longest = 0.0; // flight, s
  double off = 0.0;     // the parabola, m
  const Scene scene = run_monitored(
      resting(spec, heaving()), {.speed = 9.0, .energy_floor = 1.0}, at_time(4.0),
      [&](const Domain& domain, const Stepper& stepper) {
        const RigidBody& block = body(domain);
        const double height = block.centre().y - block.start().y;
        const bool is_free = std::ranges::none_of(
            domain.contact.nodes(0), [](const ContactNode& c) { return c.normal_impulse > 0.0; });
        if (is_free && flies) {
          const double t = stepper.time() - launch.time;
          longest = std::max(longest, t);
          off = std::max(off, std::abs(height - launch.height - (launch.velocity - 0.5 * pull * t) * t));
        } else if (is_free) { // velocities are those of half a step before
          launch = {stepper.time(), height, block.motion().velocity.y - 0.5 * pull * stepper.dt()};
        }
        flies = is_free;
      });
  const RigidBody& block = body(*scene.domain);
  reaches("time of the flight", longest, 0.3, "s");
  bounded("distance from a stone's path, in cells", off / h, 0.02);
  bounded("height after it has landed, over that before, in cells",
          std::abs(block.centre().y - block.start().y) / h, 0.05);
  bounded("tilt", std::abs(block.tilt()), 0.01, "rad");
  bounded("speed of its corners", scene.domain->contact.fastest_point(), 0.02, "m/s");
}

INSTANTIATE_TEST_SUITE_P(Thrown, HardCase42ThrownBlock, testing::Bool(),
                         [](const auto& wet) { return std::string(wet.param ? "in_water" : "in_air"); });

/// To pull a block of 4000 kg/m off with the heave's 31 m/s2 takes 53 kPa on its base, 2 m wide; water there
/// bears a suction of 100 kPa beyond its pressure at rest.
TEST(HardCase42HeldBlock, SuctionHoldsABlockOnGroundThatCannotDrain) {
  Spec spec = ground(12.0, 4.0, true, 6.0, materials::Drainage::undrained);
  spec.structures = {structure(rectangle(-1.0, 0.0, 1.0, 1.0), block_density, 0.5)};
  double pull = 0.0;  // on the block, N/m
  double apart = 0.0; // steps without a tied node
  run_monitored(resting(spec, heaving()), {.speed = 9.0, .energy_floor = 1.0}, at_time(1.0),
                [&](const Domain& domain, const Stepper&) {
                  const BodyForces forces = domain.contact.forces(0);
                  pull = std::max(pull, -forces.normal.force.y - forces.water.force.y);
                  if (std::ranges::none_of(domain.contact.nodes(0), &ContactNode::tied))
                    ++apart;
                });
  reaches("pull of the ground on the block", pull, 50e3, "N/m");
  exactly("steps in which it has left the ground", apart, 0.0);
}

} // namespace
} // namespace tremolo
