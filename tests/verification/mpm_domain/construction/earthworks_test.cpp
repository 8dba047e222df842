// Earthworks in time. Elastic ground of height H on a rigid base, damped by its mass, that gets a layer of
// thickness d on it: once it rests, soil at y has gone
//
//     u_y = -gamma d y/M   for y < H,      u_y = -gamma d H/M   in the layer,
//
// since that has the stress of its own weight from the start; and back again when the layer goes.

#include "mpm_domain/earthworks/placing.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

namespace tremolo::mpm_domain::test {
namespace {

constexpr double height = 5.0;    // H, m
constexpr double thickness = 5.0; // d, m
constexpr double width = 2.0;
constexpr double gamma = density * gravity;
constexpr double settlement = gamma * thickness * height / modulus; // 25 mm
constexpr double ramp = 2.0;                                        // s, five periods 4 (H + d)/c_p
constexpr double start = 0.1;
constexpr double removal = 3.5;
constexpr double end = 7.0;

/// Ground that is placed and removed again.
Spec built_and_dug() {
  Spec spec = level_ground(width, 0.0, height + thickness, 0.5);
  spec.regions = {layer(width, 0.0, height)};
  const Region fill = layer(width, height, height + thickness);
  spec.earthworks = {{{start, ramp}, {fill}, {}}, {{removal, ramp}, {}, {fill}}};
  spec.rigid_base = true;
  const double slowest = std::sqrt(modulus / density) * std::numbers::pi / (2.0 * (height + thickness));
  spec.soils.front().mass_damping = 2.0 * slowest;
  return spec;
}

void keep_base_still(long, double, std::span<const Vector>, std::span<eq6::FreeField> field) {
  std::ranges::fill(field, eq6::FreeField{});
}

/// The domain at rest under gravity, and its stepper.
struct GroundInMotion {
  Domain domain;
  std::unique_ptr<Stepper> stepper;

  explicit GroundInMotion(const Spec& spec) : domain(spec) {
    rest(domain, {}, 1e-9);
    stepper = std::make_unique<Stepper>(domain, 0.0, keep_base_still);
  }
  void go_to(double time) {
    while (stepper->time() < time)
      stepper->step();
  }
  double fastest() const {
    double fastest = 0.0;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        fastest = std::max(fastest, std::hypot(set.vx[k], set.vy[k]));
    return fastest;
  }
};

/// Vertical stress is that of the depth in the mean of each cell that particles began in. Next to what has
/// been placed rows of one cell differ, since boxes have moved into cells that are strained otherwise.
void expect_stress_of_depth(const Domain& domain, double top) {
  for (const Particles& set : domain.sets) {
    std::map<long, std::array<double, 2>> cells; // sums of what it should be, and of what it is
    std::map<long, double> count;
    for (std::size_t k = 0; k < set.size(); ++k) {
      const long cell = std::lround(std::floor(set.y_initial[k] / set.cell_size));
      const double exact = gamma * (set.y_initial[k] - top);
      EXPECT_NEAR(set.syy[k], exact, 0.06 * gamma * thickness) << "y = " << set.y_initial[k];
      cells[cell][0] += exact;
      cells[cell][1] += set.syy[k];
      count[cell] += 1.0;
    }
    for (const auto& [cell, sums] : cells)
      EXPECT_NEAR(sums[1] / count[cell], sums[0] / count[cell], 0.01 * gamma * thickness) << cell;
  }
}

void expect_settled_and_risen(const Spec& spec) {
  GroundInMotion ground(spec);
  const std::size_t before = ground.domain.particle_count();
  ground.go_to(removal - 0.01);
  EXPECT_GT(ground.domain.particle_count(), before);
  for (const Particles& set : ground.domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double exact = -settlement * std::min(set.y_initial[k], height) / height;
      EXPECT_NEAR(set.y[k] - set.y_initial[k], exact, 0.01 * settlement) << "y = " << set.y_initial[k];
    }
  expect_stress_of_depth(ground.domain, height + thickness);
  ground.go_to(end);
  EXPECT_EQ(ground.domain.particle_count(), before);
  for (const Particles& set : ground.domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      EXPECT_NEAR(set.y[k], set.y_initial[k], 0.01 * settlement);
  expect_stress_of_depth(ground.domain, height);
  EXPECT_LT(std::abs(ground.domain.energy.residual()), 1e-3 * gamma * thickness * width * settlement);
}

TEST(Earthworks, LetTheGroundSettleByTheWeightAndRiseWithoutIt) {
  Spec spec = built_and_dug();
  expect_settled_and_risen(spec);
  spec.refine = {{{0.0, 4.0, width, height + thickness}, 1}};
  expect_settled_and_risen(spec);
}

TEST(Earthworks, MoveNothingAtTheirStart) {
  GroundInMotion ground(built_and_dug());
  ground.go_to(start); // the next step is the first with the layer
  const std::size_t before = ground.domain.particle_count();
  ground.stepper->step();
  ASSERT_GT(ground.domain.particle_count(), before);
  EXPECT_LT(ground.fastest(), 1e-6 * gravity * ground.stepper->dt());
}

TEST(Earthworks, GoOnWithTheSameBitsFromACheckpoint) {
  const Spec spec = built_and_dug();
  for (const double broken :
       {0.05, 1.0, 4.0, 6.5}) { // before the layer, while it comes and goes, and after it
    GroundInMotion whole(spec);
    whole.go_to(broken);
    const test_support::SavedState saved = test_support::saved_state(whole.domain, *whole.stepper);
    GroundInMotion resumed(spec);
    test_support::restore_state(saved, resumed.domain, *resumed.stepper);
    whole.go_to(broken + 0.3);
    resumed.go_to(broken + 0.3);
    expect_same(test_support::saved_state(whole.domain, *whole.stepper),
                test_support::saved_state(resumed.domain, *resumed.stepper));
  }
}

TEST(Earthworks, RemoveASoilThatHasComeBack) {
  Spec spec = built_and_dug();
  const Region fill = spec.earthworks.front().place.front();
  spec.regions.push_back(fill); // there from the start
  spec.earthworks = {{{0.1, 0.1}, {}, {fill}}, {{0.3, 0.1}, {fill}, {}}, {{0.5, 0.1}, {}, {fill}}};
  GroundInMotion ground(spec);
  const std::size_t before = ground.domain.particle_count();
  ground.go_to(0.25);
  EXPECT_EQ(2 * ground.domain.particle_count(), before);
  ground.go_to(0.45);
  EXPECT_EQ(ground.domain.particle_count(), before);
  ground.go_to(0.65);
  EXPECT_EQ(2 * ground.domain.particle_count(), before);
}

/// Moves the ground up or down, as a shaking may have done.
void move_ground(Domain& domain, double way) {
  for (double& y : domain.sets.front().y)
    y += way;
}

TEST(Earthworks, PlaceSoilOnTheGroundAsItIsThen) {
  constexpr double size = 0.25; // of particles
  for (const double way : {-0.6, -0.1, 0.0, 0.4}) {
    Domain domain(built_and_dug());
    move_ground(domain, way);
    const std::vector<Particles> placed =
        soil_to_place(domain, domain.spec.earthworks.front().place.front());
    const Particles& set = placed.front();
    const double lowest = std::ranges::min(set.y) - 0.5 * size;
    EXPECT_NEAR(lowest, height + way, 0.5 * size) << "no gap, and nothing twice";
    EXPECT_NEAR(std::ranges::max(set.y) + 0.5 * size, height + thickness, 1e-9);
    const auto rows = std::ranges::count_if(set.x, [](double x) { return x < size; });
    const double top = gamma * size * static_cast<double>(rows);
    EXPECT_NEAR(std::ranges::min(set.syy), -top + 0.5 * gamma * size, 1e-9 * top);
  }
}

TEST(Earthworks, AreRefusedBelowTheWater) {
  Spec spec = built_and_dug();
  spec.soils.front().pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-3};
  spec.water = {height + 1.0, {}};
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
  spec.water = {height - 1.0, {}};
  EXPECT_NO_THROW(Domain{spec});
}

TEST(Earthworks, AreRefusedWithClocksOfTheirOwn) {
  Spec spec = built_and_dug();
  spec.refine = {{{0.0, 4.0, width, height + thickness}, 1}};
  spec.scheme.subcycle = true;
  EXPECT_THROW(Domain{spec}, std::invalid_argument);
}

TEST(Loads, ThatGrowInTimeLetTheGroundSettle) {
  Spec spec = built_and_dug();
  spec.earthworks.clear();
  spec.loads = {{0.0, width, 50e3, 0.0, Growth{start, ramp}}};
  GroundInMotion ground(spec);
  ground.go_to(start);
  EXPECT_LT(ground.fastest(), 1e-8);
  ground.go_to(removal);
  const Particles& set = ground.domain.sets.front();
  for (std::size_t k = 0; k < set.size(); ++k)
    EXPECT_NEAR(set.y[k] - set.y_initial[k], -50e3 * set.y_initial[k] / modulus,
                0.01 * 50e3 * height / modulus);
}

} // namespace
} // namespace tremolo::mpm_domain::test
