// Viscous damping at the limit of its step, sqrt(t^2 + beta^2) - beta with t = 0.65 h/c_p, which for much
// damping is a small part of t: whatever moves at random must come to rest.

#include "free_block.hpp"
#include "mpm_domain/spec/limits.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/quiet_ground.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

const materials::Elasticity soil{1700.0, 40e6, 0.28};
constexpr double cell = 0.5;   // m
constexpr double shift = 0.06; // m: off the nodes, so that some at the corners have next to no mass

/// @param damping_time in units of h/c_p
Spec damped_block(double damping_time, Transfer transfer, StepOrder order) {
  Spec spec = elastic_box(3.0, 3.0, cell);
  spec.soils.front().damping_time = damping_time * cell / soil.p_wave_speed();
  spec.scheme = {.transfer = transfer, .order = order, .fraction = share_of(order)};
  return spec;
}

/// Velocities of 1 mm/s.
void set_random(Domain& domain) {
  std::mt19937 random(1);
  std::normal_distribution<double> speed(0.0, 1e-3);
  set_velocity(domain, [&](double, double) { return Vector{speed(random), speed(random)}; });
}

/// The largest energy of the particles over that at the start, of a scene that is left to itself. At the
/// limit of the step the ledger of undamped noise misses 0.2 of its energy, with FLIP and usl 1.2; that of
/// damped noise misses less.
double growth(const MakeScene& make) {
  double start = 0.0;
  double largest = 0.0;
  const auto set_up = [&](int threads) {
    Scene scene = make(threads);
    start = particle_energy(*scene.domain);
    return scene;
  };
  run_monitored(set_up, {.speed = 1.0, .energy = 1.3}, after_steps(5000),
                [&](Domain& domain, const Stepper& stepper) {
                  if (stepper.steps() % 16 == 0)
                    largest = std::max(largest, particle_energy(domain));
                });
  return largest / start;
}

TEST(HardCase39DampedStep, RandomVelocitiesAtTheLimitOfADampedStep) {
  for (const double damping_time : {0.1, 1.0, 10.0})
    for (const Transfer transfer : {Transfer::apic, Transfer::flip})
      for (const StepOrder order : {StepOrder::musl, StepOrder::usl}) {
        const double largest = growth([&](int threads) {
          return free_scene(damped_block(damping_time, transfer, order), threads, [](Domain& domain) {
            for (double& x : domain.sets.front().x)
              x += shift;
            set_random(domain);
          });
        });
        bounded("largest energy over that at the start", largest, 1.0);
      }
}

TEST(HardCase39DampedStep, RandomVelocitiesBetweenDashpotsAtTheLimitOfADampedStep) {
  for (const double damping_time : {0.1, 1.0, 10.0}) {
    const double largest = growth([&](int threads) {
      Spec spec = damped_block(damping_time, Transfer::apic, StepOrder::musl);
      spec.threads = threads;
      Scene scene{std::make_unique<Domain>(spec), quiet_ground()};
      set_random(*scene.domain);
      return scene;
    });
    bounded("largest energy over that at the start", largest, 1.0);
  }
}

/// The order usl flies apart where its share is taken of the damped step instead of the undamped one; musl
/// holds steps of three times the limit together.
TEST(HardCase39DampedStep, TheShareOfADampedStepIsTooLarge) {
  for (const double damping_time : {1.0, 10.0}) {
    const Scene scene =
        free_scene(damped_block(damping_time, Transfer::flip, StepOrder::usl), 1, [](Domain& domain) {
          for (double& x : domain.sets.front().x)
            x += shift;
          set_random(domain);
        });
    Domain& domain = *scene.domain;
    const double undamped = 0.65 * cell / soil.p_wave_speed();
    const double dt = usl_share * damped_step(undamped, domain.sets.front().damping_time, 1.0);
    const double start = particle_energy(domain);
    double largest = 0.0;
    for (int step = 0; step < 5000 && largest < 1e6; ++step) {
      scatter(domain, ScatterPart::both);
      grid_velocities(domain, domain.soil_rows);
      update_grid(domain, dt, domain.soil_rows);
      gather(domain, dt, {.velocity = true, .position = true, .strain = true});
      largest = std::max(largest, particle_energy(domain) / start);
    }
    breaks("usl at its share of the damped limit: largest energy over that at the start", largest, 1.0);
  }
}

/// Without the share of the damping the step is refused.
TEST(HardCase39DampedStep, TheStepOfUndampedSoilIsRefused) {
  Spec spec = damped_block(1.0, Transfer::apic, StepOrder::musl);
  spec.scheme.dt = 0.65 * cell / soil.p_wave_speed();
  Domain domain(spec);
  EXPECT_THROW(Stepper(domain, 0.0, quiet_ground()), std::invalid_argument);
}

} // namespace
} // namespace tremolo
