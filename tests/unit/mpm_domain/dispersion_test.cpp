// What reduced dispersion must leave alone: sums, torque, linear motions, the power of the stresses, nodes
// without soil; and what its transfer must not lose. The soil is a ragged heap, shaken off its lattice.

#include "mpm_domain/dispersion/fullness.hpp"
#include "mpm_domain/dispersion/sharpening.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "mpm_domain/transfer/sharp_transfer.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/particle_energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tremolo::mpm_domain {
namespace {

Spec heap() {
  Spec spec = test_support::elastic_box(8.0, 6.0, 0.5);
  spec.scheme.dispersion = Dispersion::reduced;
  spec.regions.front().polygon = {{0.0, -6.0}, {8.0, -6.0}, {8.0, -3.3},
                                  {4.9, -2.1}, {3.2, 0.0},  {1.7, -4.4}};
  return spec;
}

/// Particles beside their positions, with random velocities (m/s) and stresses (Pa).
void shake(Domain& domain) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> position(-0.1, 0.1);
  std::normal_distribution<double> normal;
  for (Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.x[k] += 0.17 + position(random);
      p.y[k] += 0.08 + position(random);
      p.vx[k] = normal(random);
      p.vy[k] = normal(random);
      for (std::vector<double>* moment : {&p.bxx, &p.bxy, &p.byx, &p.byy})
        (*moment)[k] = 0.05 * normal(random);
      p.cross_x[k] = 0.01 * normal(random);
      p.cross_y[k] = 0.01 * normal(random);
      for (std::vector<double>* stress : {&p.sxx, &p.syy, &p.szz, &p.sxy})
        (*stress)[k] = 1e5 * normal(random);
    }
  sort_particles(domain);
}

struct Heap {
  Domain domain{heap()};
  double empty;

  Heap() {
    shake(domain);
    empty = empty_mass(domain);
    scatter(domain, ScatterPart::motion);
    find_fullness(domain);
  }

  /// act(node, x, y)
  template <typename Act>
  void over_nodes(const Act& act) const {
    const Grid& grid = domain.grid;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i)
        act(grid.index(i, j), grid.x0 + i * grid.h, grid.y0 + j * grid.h);
  }

  /// act(set, particle)
  template <typename Act>
  void over_particles(const Act& act) const {
    for (const Particles& p : domain.sets)
      for (std::size_t k = 0; k < p.size(); ++k)
        act(p, k);
  }

  bool has_soil(std::size_t node) const { return domain.grid.mass[node] > empty; }

  /// Random numbers at nodes with soil.
  NodeField noise(unsigned seed) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    NodeField field(domain.grid.size(), 0.0);
    over_nodes([&](std::size_t n, double, double) {
      if (has_soil(n))
        field[n] = normal(random);
    });
    return field;
  }

  double sum_of_products(const NodeField& a, const NodeField& b) const {
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
      sum += a[n] * b[n];
    return sum;
  }
};

TEST(Dispersion, TheForcesAreSharpenedByTheAdjointOfWhatSharpensVelocities) {
  Heap heap;
  Grid& grid = heap.domain.grid;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> share;
  heap.over_nodes([&](std::size_t n, double, double) {
    if (grid.inside_x[n] > 0.0)
      grid.inside_x[n] = share(random);
    if (grid.inside_y[n] > 0.0)
      grid.inside_y[n] = share(random);
  });
  const NodeField vx = heap.noise(1), vy = heap.noise(2), fx = heap.noise(3), fy = heap.noise(4);
  sharpen_velocities(heap.domain, vx, vy);
  const double strained = heap.sum_of_products(fx, grid.sharp_x) + heap.sum_of_products(fy, grid.sharp_y);
  const double plain = heap.sum_of_products(fx, vx) + heap.sum_of_products(fy, vy);
  grid.force_x = fx;
  grid.force_y = fy;
  sharpen_forces(heap.domain);
  const double forced = heap.sum_of_products(grid.force_x, vx) + heap.sum_of_products(grid.force_y, vy);
  EXPECT_NEAR(strained, forced, 1e-14 * heap.sum_of_products(fx, fx));
  EXPECT_GT(std::abs(strained - plain), 0.01 * std::abs(plain)); // Q is not nothing
}

TEST(Dispersion, LinearVelocitiesStayAtARaggedSurface) {
  Heap heap;
  NodeField vx(heap.domain.grid.size()), vy = vx;
  heap.over_nodes([&](std::size_t n, double x, double y) {
    vx[n] = 0.3 + 0.7 * x - 1.1 * y;
    vy[n] = -0.2 + 0.4 * x + 0.9 * y;
  });
  sharpen_velocities(heap.domain, vx, vy);
  heap.over_nodes([&](std::size_t n, double, double) {
    if (!heap.has_soil(n))
      return;
    EXPECT_NEAR(heap.domain.grid.sharp_x[n], vx[n], 1e-13);
    EXPECT_NEAR(heap.domain.grid.sharp_y[n], vy[n], 1e-13);
  });
}

TEST(Dispersion, UniformStrainIsExact) {
  Heap heap;
  Grid& grid = heap.domain.grid;
  heap.over_nodes([&](std::size_t n, double x, double y) {
    grid.vx_strain[n] = 0.7 * x - 1.1 * y;
    grid.vy_strain[n] = 0.4 * x + 0.9 * y;
  });
  for (Particles& p : heap.domain.sets)
    for (std::vector<double>* stress : {&p.sxx, &p.syy, &p.szz, &p.sxy})
      std::ranges::fill(*stress, 0.0);
  sharpen_strain(heap.domain);
  constexpr double dt = 1e-9;
  gather(heap.domain, dt, {.strain = true, .remapped = true, .sharp = true});
  heap.over_particles([&](const Particles& p, std::size_t k) {
    const materials::Elasticity& soil = materials::elasticity(p.law);
    const double scale = soil.p_modulus() * dt;
    EXPECT_NEAR(p.sxx[k], (soil.p_modulus() * 0.7 + soil.lame() * 0.9) * dt, 1e-8 * scale);
    EXPECT_NEAR(p.syy[k], (soil.p_modulus() * 0.9 + soil.lame() * 0.7) * dt, 1e-8 * scale);
    EXPECT_NEAR(p.sxy[k], soil.shear_modulus() * (0.4 - 1.1) * dt, 1e-8 * scale);
  });
}

/// Sum of forces 0 and sum of x f = -sum of V sigma: no gradient does otherwise, and torque is its skew part.
TEST(Dispersion, InternalForcesHaveTheMomentsOfTheStresses) {
  Heap heap;
  scatter_sharp_forces(heap.domain);
  const Grid& grid = heap.domain.grid;
  Vector force;
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0, scale = 0.0;
  heap.over_nodes([&](std::size_t n, double x, double y) {
    force = {force.x + grid.force_x[n], force.y + grid.force_y[n]};
    xx += x * grid.force_x[n];
    xy += x * grid.force_y[n];
    yx += y * grid.force_x[n];
    yy += y * grid.force_y[n];
    scale += std::abs(grid.force_x[n]);
  });
  double sxx = 0.0, syy = 0.0, sxy = 0.0;
  heap.over_particles([&](const Particles& p, std::size_t k) {
    sxx += p.volume[k] * p.sxx[k];
    syy += p.volume[k] * p.syy[k];
    sxy += p.volume[k] * p.sxy[k];
  });
  EXPECT_NEAR(force.x, 0.0, 1e-13 * scale);
  EXPECT_NEAR(force.y, 0.0, 1e-13 * scale);
  EXPECT_NEAR(xx, -sxx, 1e-12 * scale);
  EXPECT_NEAR(yy, -syy, 1e-12 * scale);
  EXPECT_NEAR(xy, -sxy, 1e-12 * scale);
  EXPECT_NEAR(yx, -sxy, 1e-12 * scale);
}

TEST(Dispersion, NodesWithoutSoilHaveNoForce) {
  Heap heap;
  scatter_sharp_forces(heap.domain);
  const Grid& grid = heap.domain.grid;
  double largest = 0.0;
  heap.over_nodes([&](std::size_t n, double, double) {
    if (grid.mass[n] == 0.0) {
      EXPECT_EQ(grid.force_x[n], 0.0);
      EXPECT_EQ(grid.force_y[n], 0.0);
    } else {
      // |f|/m of plain boxes has no bound either where a box just begins to touch a node.
      largest = std::max(largest, std::hypot(grid.force_x[n], grid.force_y[n]) / std::sqrt(grid.mass[n]));
    }
  });
  EXPECT_LT(largest, 1e6);
}

TEST(Dispersion, StressesWorkOnTheStrainsWhatForcesTakeFromTheNodes) {
  Heap heap;
  Grid& grid = heap.domain.grid;
  scatter_sharp_forces(heap.domain);
  const NodeField fx = grid.force_x, fy = grid.force_y;
  const NodeField vx = heap.noise(5), vy = heap.noise(6);
  grid.vx_strain = vx;
  grid.vy_strain = vy;
  sharpen_strain(heap.domain);
  constexpr double dt = 1e-16; // so short that stresses stay as they are
  const GatherTotals sums = gather(heap.domain, dt, {.strain = true, .remapped = true, .sharp = true});
  const double power = heap.sum_of_products(fx, vx) + heap.sum_of_products(fy, vy);
  EXPECT_NEAR(sums.works[0].value() / dt, -power, 1e-9 * std::abs(power));
}

/// Away from corners a face reads quadratic velocities along the boundary exactly.
TEST(Dispersion, FacesKeepTheMomentsOfTheirPlaces) {
  Spec spec = test_support::elastic_box(12.0, 12.0, 0.5);
  spec.scheme.dispersion = Dispersion::reduced;
  Domain domain(spec);
  scatter(domain, ScatterPart::motion);
  find_fullness(domain);
  int seen = 0;
  for (const BoundaryFace& face : domain.boundary.faces()) {
    if (face.side != Side::left || std::abs(face.position.y + 6.0) > 3.0)
      continue;
    ++seen;
    FaceWeights weights;
    face_weights(domain, face, weights);
    double sum = 0.0, first = 0.0, second = 0.0;
    for (const auto& [node, w] : weights) {
      const double y =
          domain.grid.y0 + static_cast<double>(node / static_cast<std::size_t>(domain.grid.nx)) * 0.5;
      sum += w;
      first += w * (y - face.position.y);
      second += w * std::pow(y - face.position.y, 2);
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    EXPECT_NEAR(first, 0.0, 1e-13);
    EXPECT_NEAR(second, 0.0, 1e-13);
  }
  EXPECT_GT(seen, 20);
}

/// What a particle lattice that has not moved gives back of a wave of the nodes, sin(ax + by), from the
/// nodes to the particles and back, over what it read.
double returned(Dispersion dispersion, double theta_x, double theta_y) {
  Spec spec = test_support::elastic_box(12.0, 12.0, 0.5);
  spec.scheme.dispersion = dispersion;
  Domain domain(spec);
  Grid& grid = domain.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      grid.vx_after[grid.index(i, j)] = std::sin(0.4 + theta_x * i + theta_y * j);
  gather(domain, 1.0, {.velocity = true, .sharp = domain.is_sharp()}, 0);
  scatter(domain, ScatterPart::motion);
  grid_velocities(domain, domain.soil_rows);
  const std::size_t middle = grid.index(grid.nx / 2, grid.ny / 2);
  return grid.vx_before[middle] / grid.vx_after[middle];
}

TEST(Dispersion, TheTransferKeepsObliqueWavesWithTheBilinearVelocity) {
  for (const auto& [theta_x, theta_y] : {std::pair{0.6, 0.6}, {1.1, 0.4}, {0.0, 0.9}}) {
    const double s_x = 2.0 - 2.0 * std::cos(theta_x);
    const double s_y = 2.0 - 2.0 * std::cos(theta_y);
    EXPECT_NEAR(returned(Dispersion::plain, theta_x, theta_y), 1.0 - 9.0 / 256.0 * s_x * s_y, 1e-13);
    EXPECT_NEAR(returned(Dispersion::reduced, theta_x, theta_y), 1.0, 1e-13);
  }
}

TEST(Dispersion, TheBilinearVelocityCarriesNeitherMomentumNorSpin) {
  Heap heap;
  double mass = 0.0, px = 0.0, py = 0.0, spin = 0.0;
  heap.over_particles([&](const Particles& p, std::size_t k) {
    mass += p.mass[k];
    px += p.mass[k] * p.vx[k];
    py += p.mass[k] * p.vy[k];
    spin += p.mass[k] * (p.x[k] * p.vy[k] - p.y[k] * p.vx[k] + p.byx[k] - p.bxy[k]);
  });
  const Grid& grid = heap.domain.grid;
  heap.over_nodes([&](std::size_t n, double x, double y) {
    mass -= grid.mass[n];
    px -= grid.momentum_x[n];
    py -= grid.momentum_y[n];
    spin -= x * grid.momentum_y[n] - y * grid.momentum_x[n];
  });
  constexpr double scale = 1700.0 * 48.0; // kg/m; speeds are of order 1 m/s
  EXPECT_NEAR(mass, 0.0, 1e-12 * scale);
  EXPECT_NEAR(px, 0.0, 1e-12 * scale);
  EXPECT_NEAR(py, 0.0, 1e-12 * scale);
  EXPECT_NEAR(spin, 0.0, 1e-11 * scale);
}

/// A free block that turns, off the lattice and through it.
TEST(Dispersion, ABlockThatSpinsKeepsItsAngularMomentum) {
  Spec spec = test_support::elastic_box(4.0, 4.0, 0.5);
  spec.scheme.dispersion = Dispersion::reduced;
  Domain domain(spec);
  const Vector centre{2.0, -2.0};
  constexpr double rate = 2.0; // rad/s
  for (Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k) {
      p.x[k] += 0.13;
      p.y[k] += 0.21;
      p.vx[k] = -rate * (p.y[k] - centre.y);
      p.vy[k] = rate * (p.x[k] - centre.x) + 3.0; // and flies up
    }
  sort_particles(domain);
  const auto spin = [&] {
    double sum = 0.0;
    for (const Particles& p : domain.sets)
      for (std::size_t k = 0; k < p.size(); ++k)
        sum += p.mass[k] * (p.x[k] * p.vy[k] - p.y[k] * p.vx[k] + p.byx[k] - p.bxy[k]);
    return sum;
  };
  Stepper stepper(domain, 0.0, test_support::no_traction(domain));
  stepper.step();
  const double start = spin();
  for (int step = 0; step < 400; ++step)
    stepper.step();
  EXPECT_NEAR(spin(), start, 1e-12 * std::abs(start));
}

} // namespace
} // namespace tremolo::mpm_domain
