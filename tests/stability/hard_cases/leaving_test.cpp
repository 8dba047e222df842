// Particles that come to the edge of the grid: it grows where soil may go, and otherwise the run stops and
// says which particle, where and when. None is lost in silence.

#include "mpm_domain/particles/grid_growth.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/conservation_monitor.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo {
namespace {

using namespace test_support;
using testing::HasSubstr;

/// A block without faces: all its sides are free.
Scene flying_block(int threads, Vector velocity) {
  mpm_domain::Spec spec = elastic_box(2.0, 1.0, 0.5);
  spec.threads = threads;
  Scene scene{std::make_unique<mpm_domain::Domain>(spec)};
  scene.source = no_traction(*scene.domain);
  for (mpm_domain::Particles& set : scene.domain->sets) {
    set.vx.assign(set.size(), velocity.x);
    set.vy.assign(set.size(), velocity.y);
  }
  return scene;
}

TEST(LeavingParticles, AFreeBlockTakesTheGridAlongInEveryDirection) {
  double error = 0.0;
  for (const Vector v : {Vector{20.0, 7.0}, Vector{-20.0, 7.0}, Vector{7.0, -20.0}, Vector{0.0, 20.0}}) {
    double time = 0.0;
    const Scene end = run_monitored([&](int threads) { return flying_block(threads, v); }, {.speed = 22.0},
                                    at_time(1.5), [&](auto&, const auto& stepper) { time = stepper.time(); });
    const mpm_domain::Particles& p = end.domain->sets.front();
    for (std::size_t k = 0; k < p.size(); ++k)
      error = std::max({error, std::abs(p.x[k] - p.x_initial[k] - v.x * time),
                        std::abs(p.y[k] - p.y_initial[k] - v.y * time)});
    reaches("way, in cells", 20.0 * time / 0.5, 40.0);
  }
  bounded("distance from the straight path", error, 1e-9, "m");
}

/// The whole model drifts 30 cells while a wave passes: its faces go with it, and so does the grid.
TEST(LeavingParticles, AModelThatDriftsTakesItsSidesAndTheGridAlong) {
  const Vector drift{15.0, 4.0};
  PlaneWave wave;
  wave.angle = 15.0 * std::numbers::pi / 180.0;
  wave.y_reference = -10.0;
  const auto make = [&](int threads) {
    mpm_domain::Spec spec = elastic_box(20.0, 10.0, 1.0);
    spec.threads = threads;
    auto domain = std::make_unique<mpm_domain::Domain>(spec);
    for (mpm_domain::Particles& set : domain->sets) {
      set.vx.assign(set.size(), drift.x);
      set.vy.assign(set.size(), drift.y);
    }
    mpm_domain::FreeFieldSource source = plane_wave_source(*domain, wave, true, drift);
    return Scene{std::move(domain), std::move(source)};
  };
  VelocityError error;
  const Scene end =
      run_monitored(make, {.speed = 16.0}, at_time(2.0), [&](auto& domain, const auto& stepper) {
        error.add(domain, wave, stepper.velocity_time(), drift);
      });
  bounded("error of velocity", error.relative(), 0.03);
  const mpm_domain::Particles& p = end.domain->sets.front();
  reaches("way, in cells", p.x[0] - p.x_initial[0], 30.0 - 0.1);
}

/// Runs until the domain refuses to go on and returns what it says.
std::string refusal(mpm_domain::Domain& domain, mpm_domain::Stepper& stepper) {
  try {
    for (int i = 0; i < 2000; ++i)
      stepper.step();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no particle was refused; one is at x = " << domain.sets.front().x[0];
  return {};
}

/// A grain that flies over a side with faces finds no model there; gravity is off so that it does fly.
TEST(LeavingParticles, SoilOverASideStopsTheRunWithWhichWhereAndWhen) {
  for (const auto& [x, y, vx, vy, side] :
       {std::tuple{4.0, 2.0, 5.0, 0.0, "over its right side: 4 cells beyond the faces there, at x = 12 m"},
        {4.0, 2.0, -5.0, 0.0, "over its left side: 4 cells beyond the faces there, at x = -2 m"},
        {-1.0, 2.0, 0.0, -5.0, "over its base: 4 cells beyond the faces there, at y = -4 m"}}) {
    mpm_domain::Spec spec = elastic_box(10.0, 2.0, 0.5);
    spec.box.y_max = 4.0;
    spec.soils.push_back({"grain", spec.soils[0].law});
    spec.regions.push_back({1, {{4.0, 1.5}, {4.3, 1.5}, {4.3, 1.8}, {4.0, 1.8}}});
    mpm_domain::Domain domain(spec);
    mpm_domain::Particles& grain = domain.sets[1];
    ASSERT_EQ(grain.size(), 1U);
    grain.x[0] = x;
    grain.y[0] = y;
    grain.vx[0] = vx;
    grain.vy[0] = vy;
    mpm_domain::sort_particles(domain);
    mpm_domain::Stepper stepper(domain, 0.0, quiet_ground());
    const std::string text = refusal(domain, stepper);
    EXPECT_THAT(text, HasSubstr("particle 0 of soil 'grain' at x = "));
    EXPECT_THAT(text, HasSubstr(fmt::format("t = {:.6g} s, step {}", stepper.time(), stepper.steps())));
    EXPECT_THAT(text, HasSubstr(side));
  }
}

TEST(LeavingParticles, AJumpOutOfTheGridIsNoMotion) {
  Scene scene = flying_block(1, {1.0, 0.0});
  mpm_domain::Stepper stepper(*scene.domain, 0.0, scene.source);
  stepper.step();
  for (double& v : scene.domain->sets.front().vy)
    v = 1e5; // unknown to the step that has been chosen
  EXPECT_THAT(refusal(*scene.domain, stepper), HasSubstr("has jumped out of the grid"));
}

TEST(LeavingParticles, NanIsAJump) {
  Scene scene = flying_block(1, {1.0, 0.0});
  scene.domain->sets.front().y[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(mpm_domain::make_room(*scene.domain, 0.0, 0), std::runtime_error);
}

TEST(LeavingParticles, TheGridHasALargestSize) {
  Scene scene = flying_block(1, {0.0, 1.0});
  mpm_domain::Domain& domain = *scene.domain;
  EXPECT_EQ(mpm_domain::largest_grid(domain.spec), 1e6);
  mpm_domain::resize(domain.grid, 1000, 999);
  domain.sets.front().y[0] = domain.grid.y0 + 997.0 * domain.grid.h;
  try {
    mpm_domain::make_room(domain, 2.5, 77);
    FAIL() << "a grid beyond the largest was made";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("t = 2.5 s, step 77 asks for a grid of 1.00"));
    EXPECT_THAT(error.what(), HasSubstr("the largest allowed is 1e+06"));
  }
}

} // namespace
} // namespace tremolo
