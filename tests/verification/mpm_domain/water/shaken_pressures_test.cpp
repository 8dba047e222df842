// Level sand that liquefies while it swings by a quarter of a metre, so that its particles cross from cell to
// cell in every cycle. It is even along x but for its particles, which lie off the lattice by up to a
// twentieth of a cell: so must its pressures be. If particles kept the increments of all cells that they have
// been in, their pressures would come to differ within cells by as much as neighbouring cells differ, which
// no node feels: see mpm_domain/water/pore_pressure.hpp.

#include "materials/sand/pdmy03/pdmy03.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <utility>

namespace tremolo::mpm_domain {
namespace {

constexpr double cell = 0.5;   // m
constexpr double height = 4.0; // m
constexpr double width = 2.0;  // m
constexpr double gravity = 9.81;

Spec level_sand() {
  Spec spec;
  spec.box = {0.0, -height, width, 0.0};
  spec.cell_size = cell;
  spec.gravity = gravity;
  spec.sides = Sides::periodic;
  spec.water = {0.0, {}};
  Soil sand{.name = "sand", .law = materials::pdmy03({.relative_density = 0.57})};
  sand.pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-4};
  sand.damping_time = 0.005 / (std::numbers::pi * 5.0); // 0.5 % at 5 Hz
  spec.soils = {sand};
  spec.regions = {{0, {{0.0, -height}, {width, -height}, {width, 0.0}, {0.0, 0.0}}}};
  return spec;
}

/// Moves particles off the lattice, but for those at the surface and the base; their water stays at rest.
void disturb(Domain& domain) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-0.05 * cell, 0.05 * cell);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      if (std::max(set.y[k], -height - set.y[k]) > -0.5 * cell)
        continue;
      set.x[k] += offset(random);
      set.y[k] += offset(random);
      set.pore_pressure[k] = rest_pressure(set, k);
    }
  sort_particles(domain);
}

/// A rigid base that moves with 0.3 g at 0.75 Hz, rising within 2 s.
FreeFieldSource shaken_base(Domain& domain) {
  for (BoundaryFace& face : domain.boundary.faces()) {
    face.ground.impedance_p *= 1e3;
    face.ground.impedance_s *= 1e3;
  }
  return [](long, double t, auto, auto field) {
    const double omega = 2.0 * std::numbers::pi * 0.75;
    const double v = 0.3 * gravity / omega * std::sin(omega * t) * std::min(1.0, 0.5 * t);
    std::ranges::fill(field, eq6::FreeField{{v, 0.0}, {}});
  };
}

struct Spread {
  double count = 0.0, sum = 0.0, squares = 0.0;
  void add(double q) { count += 1.0, sum += q, squares += q * q; }
  double mean() const { return sum / count; }
  double variance() const { return std::max(0.0, squares / count - mean() * mean()); }
};

/// Root of the mean variance.
template <typename Groups>
double rms(const Groups& groups) {
  double sum = 0.0;
  for (const auto& [key, group] : groups)
    sum += group.variance();
  return std::sqrt(sum / static_cast<double>(groups.size()));
}

TEST(ShakenPressures, AreEvenAlongLevelSand) {
  Domain domain(level_sand());
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  disturb(domain);
  Stepper stepper(domain, 0.0, shaken_base(domain));
  double farthest = 0.0;
  while (stepper.time() < 4.5) {
    stepper.step();
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        farthest = std::max(farthest, std::abs(set.x[k] - set.x_initial[k]));
  }
  std::map<std::pair<double, double>, Spread> cells; // of r_u
  std::map<long, Spread> rows;
  Spread all;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double excess = excess_pressure(set, k);
      const double x = set.x[k] - width * std::floor(set.x[k] / width);
      cells[{std::floor(x / cell), std::floor(set.y[k] / cell)}].add(excess / (gravity * 1000.0 * height));
      rows[std::lround(4.0 * set.y_initial[k] / cell)].add(excess / -set.vertical_at_rest[k]);
      all.add(excess / -set.vertical_at_rest[k]);
    }
  EXPECT_GT(farthest, 0.25 * cell); // every second column crosses
  EXPECT_GT(all.mean(), 0.9);
  RecordProperty("r_u_along_x", std::to_string(rms(rows)));
  EXPECT_LT(rms(cells), 1e-6);
  EXPECT_LT(rms(rows), 0.06);
  const EnergyLedger& energy = domain.energy;
  EXPECT_LT(std::abs(energy.residual()), 1e-3 * energy.plastic);
}

} // namespace
} // namespace tremolo::mpm_domain
