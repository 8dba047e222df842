// Patch tests: under a uniform stress no interior node may feel a force, f = - sum_p V_p sigma G_p = 0,
// wherever particles' boxes tile the mesh.

#include "tests/unit/mpm_domain/graded/real_weights.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain {
namespace {

using test::Basis;

/// The boxes of 2 x 2 particles in every leaf.
std::vector<mesh::Rectangle> aligned_tiles(const GradedMesh& mesh) {
  std::vector<mesh::Rectangle> tiles;
  for (const mesh::Cell& leaf : mesh.tree().leaves()) {
    const mesh::Rectangle all = mesh.tree().rectangle(leaf);
    const double l = 0.25 * mesh.tree().size(leaf.level);
    for (const double a : {1.0, 3.0})
      for (const double b : {1.0, 3.0})
        tiles.push_back(test::box_at(all.x_min + a * l, all.y_min + b * l, l));
  }
  return tiles;
}

/// The whole mesh cut at random positions.
std::vector<mesh::Rectangle> random_tiles() {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> at(0.0, 8.0);
  const auto cuts = [&] {
    std::vector<double> c{0.0, 8.0};
    for (int n = 0; n < 21; ++n)
      c.push_back(at(random));
    std::ranges::sort(c);
    return c;
  };
  const std::vector<double> x = cuts();
  const std::vector<double> y = cuts();
  std::vector<mesh::Rectangle> tiles;
  for (std::size_t j = 0; j + 1 < y.size(); ++j)
    for (std::size_t i = 0; i + 1 < x.size(); ++i)
      tiles.push_back({x[i], y[j], x[i + 1], y[j + 1]});
  return tiles;
}

/// Forces on interior nodes over a stress of 1, for normal and shear stress.
std::vector<double> forces_of(const GradedMesh& mesh, std::span<const mesh::Rectangle> tiles,
                              Basis basis = Basis::virtual_nodes) {
  test::RealWeights sums;
  for (const mesh::Rectangle& tile : tiles)
    for (const auto& [node, w] : test::real_weights(mesh, tile, basis)) {
      test::RealWeight& f = sums[node];
      f.x = w.x;
      f.y = w.y;
      f.gx -= tile.area() * w.gx;
      f.gy -= tile.area() * w.gy;
    }
  std::vector<double> forces;
  for (const auto& [node, f] : sums)
    if (f.x > 0.0 && f.x < 8.0 && f.y > 0.0 && f.y < 8.0)
      forces.insert(forces.end(), {f.gx, f.gy});
  return forces;
}

/// The largest over sigma h_fine.
double largest_force(const GradedMesh& mesh, std::span<const mesh::Rectangle> tiles,
                     Basis basis = Basis::virtual_nodes) {
  double worst = 0.0;
  for (const double f : forces_of(mesh, tiles, basis))
    worst = std::max(worst, std::abs(f));
  return worst / mesh.tree().size(mesh.tree().finest());
}

TEST(PatchTest, TilesAlignedToCells) {
  const GradedMesh mesh = test::l_shaped_mesh();
  EXPECT_LT(largest_force(mesh, aligned_tiles(mesh)), 1e-12);
  EXPECT_GT(largest_force(mesh, aligned_tiles(mesh), Basis::naive), 1.0);
}

TEST(PatchTest, TilesThatIgnoreTheMesh) {
  const GradedMesh mesh = test::l_shaped_mesh();
  EXPECT_LT(largest_force(mesh, random_tiles()), 1e-12);
  EXPECT_GT(largest_force(mesh, random_tiles(), Basis::naive), 1.0);
}

/// Boxes that overlap and leave gaps integrate with an error of their own. The levels do not add to it: its
/// root mean square is below that of a uniform mesh of root cells.
TEST(PatchTest, JitteredParticlesAreNotWorseThanOnAUniformMesh) {
  const auto noise = [](const GradedMesh& mesh) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(-0.3, 0.3);
    double sum = 0.0;
    std::size_t count = 0;
    for (int trial = 0; trial < 10; ++trial) {
      std::vector<mesh::Rectangle> tiles = aligned_tiles(mesh);
      for (mesh::Rectangle& tile : tiles) {
        const double l = 0.5 * (tile.x_max - tile.x_min);
        const double dx = share(random) * l;
        const double dy = share(random) * l;
        tile = test::box_at(tile.x_min + l + dx, tile.y_min + l + dy, l);
      }
      for (const double f : forces_of(mesh, tiles)) {
        sum += f * f;
        ++count;
      }
    }
    return std::sqrt(sum / static_cast<double>(count));
  };
  const double graded = noise(test::l_shaped_mesh());
  const GradedMesh uniform({.h = 1.0, .nx = 8, .ny = 8}, {});
  EXPECT_GT(graded, 1e-3);
  EXPECT_LT(graded, noise(uniform));
}

/// Mass, momentum and the power of internal forces: sum_I f_I . v_I = - sum_p V sigma : L.
TEST(Transfer, AcrossLevelsKeepsMassMomentumAngularMomentumAndPower) {
  const GradedMesh mesh = test::l_shaped_mesh();
  std::mt19937 random(17);
  std::normal_distribution<double> any;
  double mass = 0.0, px = 0.0, py = 0.0, spin = 0.0, power_nodes = 0.0, power_particles = 0.0, scale = 0.0;
  std::vector<double> vx(mesh.node_count()), vy(mesh.node_count());
  for (std::size_t n = 0; n < vx.size(); ++n) {
    vx[n] = any(random);
    vy[n] = any(random);
  }
  std::map<std::size_t, std::array<double, 2>> force;
  for (const test::Particle& p : test::random_particles()) {
    const double m = 1.0 + p.l, ux = any(random), uy = any(random);
    const double sxx = any(random), syy = any(random), sxy = any(random);
    double lxx = 0.0, lyy = 0.0, lxy = 0.0, lyx = 0.0;
    for (const auto& [node, w] : test::real_weights(mesh, test::box_at(p.x, p.y, p.l))) {
      mass += w.s * m;
      px += w.s * m * ux;
      py += w.s * m * uy;
      spin += w.s * m * (w.x * uy - w.y * ux);
      force[node][0] -= sxx * w.gx + sxy * w.gy;
      force[node][1] -= sxy * w.gx + syy * w.gy;
      lxx += vx[node] * w.gx;
      lxy += vx[node] * w.gy;
      lyx += vy[node] * w.gx;
      lyy += vy[node] * w.gy;
    }
    mass -= m;
    px -= m * ux;
    py -= m * uy;
    spin -= m * (p.x * uy - p.y * ux);
    power_particles -= sxx * lxx + syy * lyy + sxy * (lxy + lyx);
    scale += std::abs(sxx * lxx) + std::abs(syy * lyy);
  }
  for (const auto& [node, f] : force)
    power_nodes += f[0] * vx[node] + f[1] * vy[node];
  EXPECT_NEAR(mass, 0.0, 1e-12 * 300);
  EXPECT_NEAR(px, 0.0, 1e-12 * 300);
  EXPECT_NEAR(py, 0.0, 1e-12 * 300);
  EXPECT_NEAR(spin, 0.0, 1e-12 * 300 * 8);
  EXPECT_NEAR(power_nodes, power_particles, 1e-13 * scale);
}

} // namespace
} // namespace tremolo::mpm_domain
