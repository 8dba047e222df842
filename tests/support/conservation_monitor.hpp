#pragma once

// What every hard case must keep, whatever else it is about:
//
//     mass          sum of the particles' and of the grid's masses constant to 1e-12
//     momentum      |P - P_0 - int F_ext dt| < 1e-10 of the largest sum of m |v|, or of the impulse applied
//     energy        |residual of the ledger| < 2 % of the largest energy that took part
//     finite        every velocity, place and stress
//     particles     the number at the start, all of them on the grid
//     speed         below what the case allows
//     bits          the same on a second run, with three threads
//
// The external force is weight, under water where soil lies there, boundary tractions and loads on the
// surface, less what the lumped dashpots give back, -dt/2 sum C (v+ - v-) (grid_update.hpp). Rigid structures
// take part with their momentum, weight and energy; one that moves at the start was pushed by nothing that
// the ledger knows of.

#include "mpm_domain/step/stepper.hpp"
#include "tests/support/centred_residual.hpp"
#include "tests/support/hard_case.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace tremolo::test_support {

/// A domain ready to be stepped and what shakes it.
struct Scene {
  std::unique_ptr<mpm_domain::Domain> domain;
  mpm_domain::FreeFieldSource source; ///< none for a domain without faces
  double start = 0.0;                 ///< s
};

/// Makes the scene of a case; the monitor asks for it twice.
using MakeScene = std::function<Scene(int threads)>;

struct MonitorBounds {
  double speed = 0.0; ///< m/s
  double momentum = 1e-10;
  double energy = 0.02;
  double energy_floor = 0.0; ///< J/m; less than this is rounding, where hardly anything moves
};

class ConservationMonitor {
public:
  ConservationMonitor(const mpm_domain::Domain& domain, MonitorBounds bounds)
      : domain_(domain), bounds_(bounds), count_(domain.particle_count()), start_(totals()),
        pushed_(domain.contact.kinetic_energy()) {}

  void after(const mpm_domain::Stepper& stepper) {
    const double dt = stepper.kick();
    add_impulse({0.0, -domain_.spec.gravity * start_.weighing_mass}, dt);
    over_rigid([&](std::size_t b) { add_impulse(domain_.contact.forces(b).weight.force, dt); });
    for (std::size_t b = 0; b < domain_.contact.bodies().size(); ++b)
      if (domain_.contact.is_elastic(b))
        add_impulse(domain_.contact.structure_loads().on(b), dt);
    const mpm_domain::Boundary& boundary = domain_.boundary;
    for (std::size_t f = 0; f < boundary.faces().size(); ++f) {
      const Vector t = boundary.traction(f);
      const double length = boundary.faces()[f].length;
      add_impulse({length * t.x, length * t.y}, dt);
    }
    for (const mpm_domain::LoadedFace& face : domain_.loads.faces())
      add_impulse(face.force, dt);
    for (const mpm_domain::LeaningEdge& edge : boundary.lean().edges())
      add_impulse(edge.on_soil, dt);
    if (!boundary.faces().empty()) {
      const mpm_domain::Grid& grid = domain_.grid;
      for (std::size_t n = 0; n < grid.size(); ++n) {
        impulse_.x -= 0.5 * dt * dt * grid.dashpot_x[n] * grid.ax[n];
        impulse_.y -= 0.5 * dt * dt * grid.dashpot_y[n] * grid.ay[n];
      }
    }
    mpm_domain::EnergyLedger e = domain_.energy;
    e.kinetic_start += pushed_;
    energy_scale_ = std::max({energy_scale_, e.kinetic_start, e.kinetic, std::abs(e.elastic), e.plastic,
                              std::abs(e.gravity), std::abs(e.input)});
    residual_.after_step(e);
    if (stepper.steps() % look_every == 0)
      look();
  }

  /// Asserts the bounds.
  void finish() {
    look();
    EXPECT_TRUE(finite_) << "a velocity, place or stress is not finite";
    // Where cells are finer particles are cut: four for one.
    const std::size_t more = domain_.particle_count() - count_;
    EXPECT_TRUE(domain_.mesh ? domain_.particle_count() >= count_ && more % 3 == 0 : more == 0) << more;
    EXPECT_EQ(outside_, 0U) << "particles beyond the grid";
    monitored("mass", mass_ / start_.mass, 1e-12);
    monitored("momentum", momentum_ / std::max({speed_scale_, impulse_scale_, 1e-300}), bounds_.momentum);
    const double scale = std::max(energy_scale_, bounds_.energy_floor);
    if (scale > 0.0)
      monitored("energy", residual_.largest() / scale, bounds_.energy);
    monitored("largest speed", largest_speed_, bounds_.speed, "m/s");
  }

private:
  /// Steps between two looks at all particles.
  static constexpr long look_every = 16;

  struct Totals {
    double mass = 0.0;          ///< of particles
    double weighing_mass = 0.0; ///< less that of displaced water
    Vector momentum;
    double momentum_size = 0.0; ///< sum m |v|
    double speed = 0.0;
  };

  void add_impulse(Vector force, double dt) {
    impulse_.x += dt * force.x;
    impulse_.y += dt * force.y;
    impulse_scale_ += dt * std::hypot(force.x, force.y);
  }

  template <class Act>
  void over_rigid(const Act& act) const {
    for (std::size_t b = 0; b < domain_.contact.bodies().size(); ++b)
      if (!domain_.contact.is_elastic(b))
        act(b);
  }

  Totals totals() {
    Totals sum;
    const auto add = [&](double mass, const Vector& v) {
      const double speed = std::hypot(v.x, v.y);
      sum.momentum.x += mass * v.x;
      sum.momentum.y += mass * v.y;
      sum.momentum_size += mass * speed;
      sum.speed = std::max(sum.speed, speed);
    };
    over_rigid([&](std::size_t b) {
      const mpm_domain::RigidBody& body = domain_.contact.bodies()[b];
      add(body.mass(), body.motion().velocity);
      finite_ =
          finite_ && std::isfinite(body.centre().x + body.centre().y + body.tilt() + body.motion().spin);
    });
    for (const mpm_domain::Particles& p : domain_.sets)
      for (std::size_t k = 0; k < p.size(); ++k) {
        sum.mass += p.mass[k];
        sum.weighing_mass += p.weight_share * p.mass[k];
        add(p.mass[k], {p.vx[k], p.vy[k]});
        finite_ = finite_ && std::isfinite(p.x[k] + p.y[k] + p.vx[k] + p.vy[k] + p.sxx[k] + p.syy[k] +
                                           p.szz[k] + p.sxy[k] + p.volume[k]);
      }
    return sum;
  }

  void look() {
    const Totals now = totals();
    double on_grid = 0.0;
    for (const double m : domain_.grid.mass)
      on_grid += m;
    mass_ = std::max({mass_, std::abs(now.mass - start_.mass), std::abs(on_grid - start_.mass)});
    momentum_ = std::max(momentum_, std::hypot(now.momentum.x - start_.momentum.x - impulse_.x,
                                               now.momentum.y - start_.momentum.y - impulse_.y));
    speed_scale_ = std::max(speed_scale_, now.momentum_size);
    largest_speed_ = std::max(largest_speed_, now.speed);
    outside_ = 0;
    for (const mpm_domain::Particles& p : domain_.sets) {
      const mpm_domain::Lattice& grid = p.body ? domain_.bodies[*p.body].lattice : domain_.grid;
      for (std::size_t k = 0; k < p.size(); ++k)
        if (!(p.x[k] > grid.x0 && p.x[k] < grid.x0 + (grid.nx - 1) * grid.h && p.y[k] > grid.y0 &&
              p.y[k] < grid.y0 + (grid.ny - 1) * grid.h))
          ++outside_;
    }
  }

  const mpm_domain::Domain& domain_;
  MonitorBounds bounds_;
  std::size_t count_;
  bool finite_ = true;
  Totals start_;
  double pushed_; ///< energy of the structures at the start, J/m
  Vector impulse_;
  double impulse_scale_ = 0.0;
  double speed_scale_ = 0.0;
  double mass_ = 0.0;
  double momentum_ = 0.0;
  CentredResidual residual_;
  double energy_scale_ = 0.0;
  double largest_speed_ = 0.0;
  std::size_t outside_ = 0;
};

/// What two runs must have alike.
struct Early {
  std::vector<mpm_domain::Particles> sets;
  std::vector<std::vector<double>> bodies;

  Early() = default;
  explicit Early(const mpm_domain::Domain& domain) : sets(domain.sets) {
    for (const mpm_domain::RigidBody& body : domain.contact.bodies())
      bodies.push_back(body.state());
  }
};

inline void expect_same_bits(const std::vector<mpm_domain::Particles>& a,
                             const std::vector<mpm_domain::Particles>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t s = 0; s < a.size(); ++s) {
    EXPECT_EQ(a[s].id, b[s].id);
    EXPECT_EQ(a[s].x, b[s].x);
    EXPECT_EQ(a[s].vy, b[s].vy);
    EXPECT_EQ(a[s].sxx, b[s].sxx);
    EXPECT_EQ(a[s].sxy, b[s].sxy);
    EXPECT_EQ(a[s].state, b[s].state);
  }
}

/// Runs a case until `done`, monitored; after_step is called after each step.
/// @returns the scene at its end
inline Scene
run_monitored(const MakeScene& make, MonitorBounds bounds,
              const std::function<bool(const mpm_domain::Stepper&)>& done,
              const std::function<void(mpm_domain::Domain&, const mpm_domain::Stepper&)>& after_step = {}) {
  constexpr long compared_steps = 40;
  Scene scene = make(1);
  Early early;
  long early_steps = 0;
  {
    mpm_domain::Stepper stepper(*scene.domain, scene.start, scene.source);
    ConservationMonitor monitor(*scene.domain, bounds);
    while (!done(stepper)) {
      stepper.step();
      monitor.after(stepper);
      if (after_step)
        after_step(*scene.domain, stepper);
      if (stepper.steps() <= compared_steps)
        early_steps = stepper.steps();
      if (stepper.steps() == compared_steps)
        early = Early(*scene.domain);
    }
    monitor.finish();
  }
  if (early_steps < compared_steps)
    early = Early(*scene.domain);
  Scene again = make(3);
  mpm_domain::Stepper stepper(*again.domain, again.start, again.source);
  while (stepper.steps() < early_steps)
    stepper.step();
  expect_same_bits(early.sets, again.domain->sets);
  EXPECT_EQ(early.bodies, Early(*again.domain).bodies);
  return scene;
}

inline std::function<bool(const mpm_domain::Stepper&)> after_steps(long steps) {
  return [steps](const mpm_domain::Stepper& stepper) { return stepper.steps() >= steps; };
}

inline std::function<bool(const mpm_domain::Stepper&)> at_time(double time) {
  return [time](const mpm_domain::Stepper& stepper) { return stepper.time() >= time; };
}

} // namespace tremolo::test_support
