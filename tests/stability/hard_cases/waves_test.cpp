// Long runs of waves in free blocks: nothing may grow.

#include "free_block.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/transfer/scatter.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

/// Gives each particle the velocity that the grid has at its place once all particles have been mapped to it.
void take_velocity_of_grid(Domain& domain) {
  scatter(domain, ScatterPart::motion);
  Grid& grid = domain.grid;
  grid_velocities(domain, domain.soil_rows);
  grid.vx_after = grid.vx_before;
  grid.vy_after = grid.vy_before;
  // FLIP adds the change of the grid's velocity to that of a particle; here both start from zero.
  Particles& p = domain.sets.front();
  for (std::vector<double>* v : {&p.vx, &p.vy})
    std::ranges::fill(*v, 0.0);
  for (NodeField* v : {&grid.vx_before, &grid.vy_before})
    std::ranges::fill(*v, 0.0);
  gather(domain, 1.0, {.velocity = true});
}

/// Kinetic energy of the part of the particles' velocities that brings no momentum to any node, J/m. Taking
/// off what they read from the grid, again and again, leaves nothing else.
double unseen_energy(Domain& domain) {
  Particles& p = domain.sets.front();
  for (int i = 0; i < 3000; ++i) {
    const std::vector<double> vx = p.vx;
    const std::vector<double> vy = p.vy;
    take_velocity_of_grid(domain);
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.vx[k] = vx[k] - p.vx[k];
      p.vy[k] = vy[k] - p.vy[k];
    }
  }
  return kinetic_energy(domain);
}

/// FLIP leaves velocities that the grid does not see, its null space, to themselves. Random places of the
/// particles feed them.
TEST(HardCase01FreeBar, FreeBarWithParticlesAtRandomPlaces) {
  const auto make = [](int threads) {
    Spec spec = elastic_box(10.0, 1.0, 0.5);
    spec.scheme.transfer = Transfer::flip;
    return free_scene(spec, threads, [](Domain& domain) {
      std::mt19937 random(1);
      std::uniform_real_distribution<double> offset(-0.05, 0.05);
      Particles& p = domain.sets.front();
      for (std::size_t k = 0; k < p.size(); ++k) {
        p.x[k] += offset(random);
        p.y[k] += offset(random);
      }
      set_velocity(domain, [](double x, double) {
        return Vector{0.01 * std::cos(std::numbers::pi * x / 10.0), 0.0};
      });
    });
  };
  EnergyAtTime energy;
  const Scene end = run_monitored(make, {.speed = 0.05}, after_steps(100000),
                                  [&](Domain& d, const Stepper&) { energy.after_step(d); });
  reaches("lowest energy over that at the start", energy.lowest / energy.start, 0.95);
  bounded("highest energy over that at the start", energy.highest / energy.start, 1.05);
  // In the mean over time half of the energy is kinetic.
  bounded("velocity that the grid does not see, over all",
          std::sqrt(unseen_energy(*end.domain) / (0.5 * energy.start)), 0.05);
}

/// Standing shear wave over eight cells, at 0.8 of the limit of uGIMP, 0.746 h/c_p.
void expect_standing_wave(long steps) {
  const auto make = [](int threads) {
    Spec spec = elastic_box(0.5, 4.0, 0.5);
    spec.sides = mpm_domain::Sides::periodic;
    spec.scheme.transfer = Transfer::flip;
    spec.scheme.fraction = 0.8 * 0.746 / 0.65;
    return free_scene(spec, threads, [](Domain& domain) {
      set_velocity(domain, [](double, double y) {
        return Vector{1e-3 * std::cos(std::numbers::pi * y / 4.0), 0.0};
      });
    });
  };
  EnergyAtTime energy;
  run_monitored(make, {.speed = 2e-3}, after_steps(steps),
                [&](Domain& d, const Stepper&) { energy.after_step(d); });
  bounded("highest energy over that at the start", energy.highest / energy.start, 1.02);
}

TEST(HardCase08StandingWave, StandingWaveForTwoHundredThousandSteps) {
  expect_standing_wave(200000);
}

TEST(HardCase08StandingWave, AcceptanceStandingWaveForAMillionSteps) {
  expect_standing_wave(1000000);
}

/// A hundredfold stiffness from one step to the next, as of a sand that is unloaded or closes up.
class HardCase09StiffnessJump : public testing::Test {
protected:
  static Scene block(int threads) {
    Spec spec = elastic_box(4.0, 4.0, 0.5);
    spec.scheme.transfer = Transfer::flip;
    return free_scene(spec, threads, [](Domain& domain) {
      set_velocity(domain, [](double x, double y) {
        return Vector{0.01 * std::cos(std::numbers::pi * x / 4.0),
                      0.01 * std::cos(std::numbers::pi * y / 4.0)};
      });
    });
  }
  static void stiffen(Domain& domain) {
    for (Particles& p : domain.sets)
      p.law = materials::LinearElastic{{1700.0, 40e8, 0.28}};
  }
};

TEST_F(HardCase09StiffnessJump, StiffnessJumpsHundredfold) {
  double dt_before = 0.0;
  double dt_after = 0.0;
  double kinetic_before = 0.0;
  double kinetic_after = 0.0;
  run_monitored(block, {.speed = 0.05}, after_steps(5000), [&](Domain& d, const Stepper& s) {
    double& highest = s.steps() <= 500 ? kinetic_before : kinetic_after;
    highest = std::max(highest, d.energy.kinetic);
    if (s.steps() == 500) {
      dt_before = s.dt();
      stiffen(d);
    }
    dt_after = s.dt();
  });
  bounded("step after the jump over the step before", dt_after / dt_before, 0.1001);
  bounded("largest kinetic energy after over before", kinetic_after / kinetic_before, 1.0);
}

TEST_F(HardCase09StiffnessJump, AStepThatDoesNotFollowTheStiffnessGrows) {
  Scene scene = block(1);
  Domain& domain = *scene.domain;
  const double dt = 0.5 * critical_time_step(domain, 0.0);
  double before = 0.0;
  double after = 0.0;
  for (int step = 0; step < 600; ++step) {
    if (step == 500)
      stiffen(domain);
    scatter(domain, ScatterPart::both);
    grid_velocities(domain, domain.soil_rows);
    const double kinetic = update_grid(domain, dt, domain.soil_rows)[0].value();
    if (!std::isfinite(kinetic) || kinetic > 1e10) {
      after = kinetic;
      break;
    }
    gather(domain, dt, {.velocity = true});
    gather(domain, dt, {.strain = true});
    (step < 500 ? before : after) = std::max(step < 500 ? before : after, kinetic);
  }
  breaks("a step chosen from the first stiffness: kinetic energy after over before", after / before, 1e6);
}

} // namespace
} // namespace tremolo
