// Particles that cross cells, stand on their faces, or are alone.

#include "bar_1d.hpp"
#include "free_block.hpp"
#include "mpm_domain/transfer/gather.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double modulus = 40e6 * 0.72 / (1.28 * 0.44); // of P waves, Pa
constexpr double c_p = 173.4364837735801;               // m/s
constexpr double h = 0.5;                               // m
constexpr double preload = 1e5;                         // Pa
constexpr double drift = 2.0;                           // m/s

TEST(HardCase02GridCrossing, AnUnloadedBlockDriftsFiftyCells) {
  double stress = 0.0;
  double time = 0.0;
  const auto make = [](int threads) {
    return free_scene(elastic_box(4.0, 2.0, h), threads, [](Domain& domain) {
      set_velocity(domain, [](double, double) { return Vector{2.0, 0.7}; });
    });
  };
  run_monitored(make, {.speed = 2.2}, at_time(50.0 * h / 2.0), [&](Domain& d, const Stepper& s) {
    stress = std::max(stress, largest_stress(d));
    time = s.time();
  });
  reaches("cells crossed", 2.0 * time / h, 50.0);
  bounded("largest stress over M", stress / modulus, 1e-10);
}

/// Lays the strip anew with 15 particles in each of 7 rows over its 8 cells: boxes of 4 m/15 that tile it and
/// do not fit the cells, so that particles cross one after the other.
void lay_across_cells(Domain& domain) {
  constexpr std::size_t columns = 15;
  constexpr std::size_t count = columns * 7;
  constexpr double size = 8.0 * h / columns;
  Particles& p = domain.sets.front();
  p.for_fields([](const ParticleFieldDescription&, std::vector<double>& values) { values.resize(count); });
  p.id.resize(count);
  p.index_of.clear();
  p.half_size = 0.5 * size;
  for (std::size_t k = 0; k < count; ++k) {
    p.id[k] = static_cast<std::uint32_t>(k);
    p.x[k] = p.x_initial[k] = (static_cast<double>(k % columns) + 0.5) * size;
    p.y[k] = p.y_initial[k] = -(static_cast<double>(k / columns) + 0.5) * size;
    p.volume[k] = size * size;
    p.mass[k] = 1700.0 * size * size;
  }
}

/// A strip without ends under initial stress along it, which nothing needs to hold: what changes is noise.
TEST(HardCase02GridCrossing, APreloadedStripDriftsFiftyCells) {
  const auto make = [](int threads) {
    Spec spec = elastic_box(4.0, 2.0, h);
    spec.sides = mpm_domain::Sides::periodic;
    return free_scene(spec, threads, [](Domain& domain) {
      lay_across_cells(domain);
      Particles& p = domain.sets.front();
      p.sxx.assign(p.size(), -preload);
      set_velocity(domain, [](double, double) { return Vector{drift, 0.0}; });
    });
  };
  double noise = 0.0;
  run_monitored(make, {.speed = 1.01 * drift}, at_time(50.0 * h / drift), [&](Domain& d, const Stepper&) {
    const Particles& p = d.sets.front();
    for (std::size_t k = 0; k < p.size(); ++k)
      noise = std::max({noise, std::abs(p.sxx[k] + preload), std::abs(p.syy[k]), std::abs(p.sxy[k])});
  });
  bounded("noise over (v/c) M", noise / (drift / c_p * modulus), 1e-3);
  breaks("linear shape functions, the same in one dimension: noise over (v/c) M",
         Bar1D::preloaded_ring(8, 15, h, 0.0, preload, drift, 50).noise() / (drift / c_p * modulus), 1e-3);
}

/// Offsets of the block that leave its last nodes with hardly any mass.
constexpr double offsets[] = {1e-6, 1e-3, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0 - 1e-6};

TEST(HardCase03EdgeInANewCell, BlockEdgeInsideANewCellLeavesTheCriticalStep) {
  double smallest = 1e300;
  for (const double offset : offsets) {
    const Scene scene = free_scene(elastic_box(3.0, 3.0, h), 1, [&](Domain& domain) {
      Particles& p = domain.sets.front();
      for (std::size_t k = 0; k < p.size(); ++k) {
        p.x[k] += offset * h;
        p.y[k] += offset * h;
      }
    });
    const double step = critical_step(*scene.domain);
    smallest = std::min(smallest, step);
  }
  reaches("smallest critical step over h/c_p", smallest, 0.74);
  // The particle nearest to the end, a quarter of a cell behind it, 1e-6 of a cell inside the new one.
  const double linear = Bar1D::block(8, h, 0.0, 0.25 + 1e-6).critical_step();
  hard_case::add_row("wrong", "linear shape functions in one dimension: critical step over h/c_p", linear,
                     "<", 0.74, "");
  EXPECT_LT(linear, 0.74);
}

TEST(HardCase03EdgeInANewCell, BlockEdgeInsideANewCellIsNotAcceleratedMore) {
  double worst = 0.0;
  for (const double offset : offsets) {
    const auto make = [&](int threads) {
      return free_scene(elastic_box(4.0, 4.0, h), threads, [&](Domain& domain) {
        Particles& p = domain.sets.front();
        for (std::size_t k = 0; k < p.size(); ++k) {
          p.x[k] += offset * h;
          p.y[k] += offset * h;
        }
        set_velocity(domain, [](double x, double y) {
          return Vector{0.01 * std::cos(std::numbers::pi * x / 4.0),
                        0.01 * std::cos(std::numbers::pi * y / 4.0)};
        });
      });
    };
    double inside = 0.0;
    double edge = 0.0;
    run_monitored(make, {.speed = 0.05}, after_steps(300), [&](Domain& d, const Stepper&) {
      const Particles& p = d.sets.front();
      for (std::size_t k = 0; k < p.size(); ++k) {
        const Vector a = particle_acceleration(d, p, k);
        const bool at_edge =
            std::min({p.x_initial[k], 4.0 - p.x_initial[k], -p.y_initial[k], 4.0 + p.y_initial[k]}) < h;
        double& largest = at_edge ? edge : inside;
        largest = std::max(largest, std::hypot(a.x, a.y));
      }
    });
    worst = std::max(worst, edge / inside);
  }
  bounded("largest acceleration of a particle at the edge over one inside", worst, 2.0);
}

/// Velocities belong to half a step before: vy = +g dt/2 there is rest at t = 0.
TEST(HardCase04LoneParticle, OneParticleFallsForTenSeconds) {
  static constexpr double dt = 2e-3;
  constexpr double gravity = 9.81;
  const auto make = [](int threads) {
    Spec spec = elastic_box(1.0, 1.0, 1.0);
    spec.gravity = gravity;
    spec.scheme.dt = dt;
    spec.regions = {{0, {{0.1, -0.9}, {0.4, -0.9}, {0.4, -0.6}, {0.1, -0.6}}}};
    return free_scene(spec, threads, [](Domain& domain) {
      set_velocity(domain, [](double, double) { return Vector{0.0, 0.5 * gravity * dt}; });
    });
  };
  double error = 0.0;
  double stress = 0.0;
  const Scene end =
      run_monitored(make, {.speed = 98.2}, at_time(10.0 - 1e-9), [&](Domain& d, const Stepper& s) {
        const Particles& p = d.sets.front();
        error = std::max(error, std::abs(p.y[0] - p.y_initial[0] + 0.5 * gravity * s.time() * s.time()));
        stress = std::max(stress, largest_stress(d));
      });
  exactly("particles", static_cast<double>(end.domain->particle_count()), 1.0);
  bounded("distance from -g t^2/2", error, 1e-8, "m");
  bounded("largest stress over M", stress / modulus, 1e-12);
}

} // namespace
} // namespace tremolo
