#pragma once

// Blocks of elastic soil with no boundary but their own surface, and what is asked of them.

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/conservation_monitor.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/particle_energy.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <random>

namespace tremolo::test_support {

/// A domain of the spec without faces, its particles set by `set_up`.
inline Scene free_scene(mpm_domain::Spec spec, int threads,
                        const std::function<void(mpm_domain::Domain&)>& set_up) {
  spec.threads = threads;
  Scene scene{std::make_unique<mpm_domain::Domain>(spec)};
  scene.source = no_traction(*scene.domain);
  set_up(*scene.domain);
  mpm_domain::sort_particles(*scene.domain);
  return scene;
}

template <typename Field>
void set_velocity(mpm_domain::Domain& domain, const Field& field) {
  for (mpm_domain::Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      const Vector v = field(p.x[k], p.y[k]);
      p.vx[k] = v.x;
      p.vy[k] = v.y;
    }
}

/// Largest |stress| of any particle, Pa.
inline double largest_stress(const mpm_domain::Domain& domain) {
  double largest = 0.0;
  for (const mpm_domain::Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      largest = std::max({largest, std::abs(p.sxx[k]), std::abs(p.syy[k]), std::abs(p.sxy[k])});
  return largest;
}

/// Kinetic and elastic energy of the particles at one time, J/m, and its range from the first step on:
/// leapfrog knows velocity half a step before and after stress, and the mean of both energies belongs to it.
class EnergyAtTime {
public:
  void after_step(const mpm_domain::Domain& domain) {
    const double kinetic = kinetic_energy(domain);
    if (steps_ >= 1) {
      const double energy = 0.5 * (kinetic_ + kinetic) + elastic_;
      if (steps_ == 1)
        start = lowest = highest = energy;
      lowest = std::min(lowest, energy);
      highest = std::max(highest, energy);
    }
    ++steps_;
    kinetic_ = kinetic;
    elastic_ = elastic_energy(domain);
  }

  double start = 0.0, lowest = 0.0, highest = 0.0;

private:
  long steps_ = 0;
  double kinetic_ = 0.0;
  double elastic_ = 0.0;
};

/// The critical time step of a free elastic domain, 2/omega_max in units of h/c_p, by iteration with the
/// passes of the code itself: velocities, strains, stresses, forces, a = f/m.
inline double critical_step(mpm_domain::Domain& domain) {
  using namespace mpm_domain;
  Grid& grid = domain.grid;
  scatter(domain, ScatterPart::motion);
  const double empty = empty_mass(domain);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const bool full = grid.mass[n] > empty;
    grid.vx_after[n] = full ? normal(random) : 0.0;
    grid.vy_after[n] = full ? normal(random) : 0.0;
  }
  std::vector<std::vector<double>> volumes;
  for (const Particles& p : domain.sets)
    volumes.push_back(p.volume);
  constexpr double small = 1e-6; // strain, s: rotation of stress and change of volume do not matter
  double square = 0.0;
  for (int i = 0; i < 4000; ++i) {
    for (std::size_t s = 0; s < domain.sets.size(); ++s) {
      Particles& p = domain.sets[s];
      for (std::vector<double>* stress : {&p.sxx, &p.syy, &p.szz, &p.sxy})
        stress->assign(p.size(), 0.0);
      p.volume = volumes[s];
    }
    gather(domain, small, {.strain = true});
    for (std::size_t s = 0; s < domain.sets.size(); ++s)
      domain.sets[s].volume = volumes[s];
    scatter(domain, ScatterPart::force);
    double largest = 0.0;
    double vv = 0.0;
    double va = 0.0;
    for (std::size_t n = 0; n < grid.size(); ++n) {
      if (grid.mass[n] <= empty)
        continue;
      const double ax = -grid.force_x[n] / (grid.mass[n] * small);
      const double ay = -grid.force_y[n] / (grid.mass[n] * small);
      vv += grid.mass[n] * (grid.vx_after[n] * grid.vx_after[n] + grid.vy_after[n] * grid.vy_after[n]);
      va += grid.mass[n] * (grid.vx_after[n] * ax + grid.vy_after[n] * ay);
      grid.vx_after[n] = ax;
      grid.vy_after[n] = ay;
      largest = std::max({largest, std::abs(ax), std::abs(ay)});
    }
    square = va / vv;
    for (std::size_t n = 0; n < grid.size(); ++n) {
      grid.vx_after[n] /= largest;
      grid.vy_after[n] /= largest;
    }
  }
  return 2.0 / std::sqrt(square) * domain.fastest_wave() / grid.h;
}

} // namespace tremolo::test_support
