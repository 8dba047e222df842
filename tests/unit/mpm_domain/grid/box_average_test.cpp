// What the weights of a conforming basis must satisfy, for particles of any size anywhere between the levels;
// and that the naive basis does not.

#include "mpm_domain/kernel/kernel.hpp"
#include "tests/unit/mpm_domain/graded/real_weights.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain {
namespace {

using test::Basis;

TEST(BoxAverage, IsAPartitionOfUnityThatReproducesLinearFields) {
  const GradedMesh mesh = test::l_shaped_mesh();
  for (const test::Particle& p : test::random_particles()) {
    double s = 0.0, sx = 0.0, sy = 0.0, gx = 0.0, gy = 0.0, gxx = 0.0, gxy = 0.0, gyx = 0.0, gyy = 0.0;
    for (const auto& [node, w] : test::real_weights(mesh, test::box_at(p.x, p.y, p.l))) {
      s += w.s;
      sx += w.s * w.x;
      sy += w.s * w.y;
      gx += w.gx;
      gy += w.gy;
      gxx += w.gx * w.x;
      gxy += w.gx * w.y;
      gyx += w.gy * w.x;
      gyy += w.gy * w.y;
    }
    EXPECT_NEAR(s, 1.0, 1e-12);
    EXPECT_NEAR(sx, p.x, 1e-12);
    EXPECT_NEAR(sy, p.y, 1e-12);
    EXPECT_NEAR(gx, 0.0, 1e-12);
    EXPECT_NEAR(gy, 0.0, 1e-12);
    EXPECT_NEAR(gxx, 1.0, 1e-12);
    EXPECT_NEAR(gxy, 0.0, 1e-12);
    EXPECT_NEAR(gyx, 0.0, 1e-12);
    EXPECT_NEAR(gyy, 1.0, 1e-12);
  }
}

/// Largest | G - dS/dx | times the root cell, by central differences.
double gradient_error(Basis basis) {
  const GradedMesh mesh = test::l_shaped_mesh();
  constexpr double step = 1e-7;
  double worst = 0.0;
  for (const test::Particle& p : test::random_particles()) {
    const auto at = [&](double dx, double dy) {
      return test::real_weights(mesh, test::box_at(p.x + dx, p.y + dy, p.l), basis);
    };
    auto [left, right, below, above] = std::array{at(-step, 0), at(step, 0), at(0, -step), at(0, step)};
    for (const auto& [node, w] : at(0.0, 0.0)) {
      worst = std::max({worst, std::abs(w.gx - (right[node].s - left[node].s) / (2.0 * step)),
                        std::abs(w.gy - (above[node].s - below[node].s) / (2.0 * step))});
    }
  }
  return worst;
}

TEST(BoxAverage, GIsTheGradientOfS) {
  EXPECT_LT(gradient_error(Basis::virtual_nodes), 1e-6);
}

TEST(BoxAverage, TheNaiveBasisHasAnotherGradient) {
  EXPECT_GT(gradient_error(Basis::naive), 1.0);
}

TEST(BoxAverage, IsNeverNegative) {
  const GradedMesh mesh = test::l_shaped_mesh();
  for (const test::Particle& p : test::random_particles())
    for (const auto& [node, w] : test::real_weights(mesh, test::box_at(p.x, p.y, p.l)))
      EXPECT_GE(w.s, -1e-14);
}

struct Jumps {
  double s = 0.0;
  double g = 0.0;
};

/// Largest change of S and G between neighbouring points of an oblique line through all levels.
Jumps largest_jumps(double l, double step, Basis basis = Basis::virtual_nodes) {
  const GradedMesh mesh = test::l_shaped_mesh();
  Jumps jumps;
  test::RealWeights before;
  for (double s = 0.0; s < 4.0; s += step) {
    test::RealWeights now = test::real_weights(mesh, test::box_at(1.31 + 0.9 * s, 1.73 + 0.43 * s, l), basis);
    if (!before.empty()) {
      for (const auto& [node, w] : now)
        before[node]; // weights that have come or gone count too
      for (const auto& [node, w] : before) {
        const test::RealWeight next = now[node];
        jumps.s = std::max(jumps.s, std::abs(next.s - w.s));
        jumps.g = std::max({jumps.g, std::abs(next.gx - w.gx), std::abs(next.gy - w.gy)});
      }
    }
    before = now;
  }
  return jumps;
}

TEST(BoxAverage, HasContinuousGradientsWhereParticlesHaveASize) {
  for (const double l : {0.125, 0.25})
    EXPECT_GT(largest_jumps(l, 2e-3).g / largest_jumps(l, 1e-3).g, 1.9);
}

/// A point crosses from one cell to the next: gradients jump, weights do not. Those of the naive basis do.
TEST(BoxAverage, OfAPointIsContinuousButItsGradientIsNot) {
  EXPECT_GT(largest_jumps(0.0, 2e-3).s / largest_jumps(0.0, 1e-3).s, 1.9);
  EXPECT_NEAR(largest_jumps(0.0, 2e-3).g / largest_jumps(0.0, 1e-3).g, 1.0, 0.02);
  EXPECT_GT(largest_jumps(0.0, 1e-3, Basis::naive).s, 0.1);
}

/// On one lattice the weights are the tensor products of uGIMP, also on the quarters of a split cell.
TEST(BoxAverage, IsTheTensorProductOnOneLattice) {
  const GradedMesh mesh = test::l_shaped_mesh();
  struct Place {
    std::size_t lattice;
    mesh::Rectangle within; // of the particle's centre
    double l;
  };
  const std::vector<Place> positions{{0, {0.3, 7.3, 7.5, 7.7}, 0.25},  // plain root cells
                                     {1, {4.8, 2.6, 5.6, 3.2}, 0.125}, // half-metre leaves
                                     {1, {1.26, 2.3, 1.7, 3.7}, 0.25}, // quarters of split root cells
                                     {2, {2.63, 2.63, 3.37, 3.37}, 0.0625}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const Place& position : positions)
    for (int n = 0; n < 50; ++n) {
      const double x =
          position.within.x_min + share(random) * (position.within.x_max - position.within.x_min);
      const double y =
          position.within.y_min + share(random) * (position.within.y_max - position.within.y_min);
      const Lattice& lattice = mesh.lattices()[position.lattice];
      const Weights wx = gimp_weights(x, {lattice.x0, lattice.h}, position.l);
      const Weights wy = gimp_weights(y, {lattice.y0, lattice.h}, position.l);
      std::vector<BoxWeight> weights;
      box_average(mesh, test::box_at(x, y, position.l), weights);
      std::map<std::size_t, BoxWeight> sums;
      for (const BoxWeight& w : weights) {
        BoxWeight& sum = sums[w.node];
        sum.s += w.s;
        sum.gx += w.gx;
        sum.gy += w.gy;
      }
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) {
          const BoxWeight sum = sums[lattice.index(wx.base + i, wy.base + j)];
          EXPECT_NEAR(sum.s, wx.s[i] * wy.s[j], 1e-14);
          EXPECT_NEAR(sum.gx, wx.g[i] * wy.s[j], 1e-13);
          EXPECT_NEAR(sum.gy, wx.s[i] * wy.g[j], 1e-13);
        }
      double total = 0.0;
      for (const auto& [node, sum] : sums)
        total += lattice.first <= node && node < lattice.first + lattice.count() ? sum.s : 0.0;
      EXPECT_NEAR(total, 1.0, 1e-14);
    }
}

/// Four quarters of a box: sum of S/4 and G/4 is that of the box, whatever the levels.
TEST(BoxAverage, OfTheQuartersOfABoxIsThatOfTheBox) {
  const GradedMesh mesh = test::l_shaped_mesh();
  for (const test::Particle& p : test::random_particles()) {
    test::RealWeights parent = test::real_weights(mesh, test::box_at(p.x, p.y, p.l));
    for (const double dx : {-0.5 * p.l, 0.5 * p.l})
      for (const double dy : {-0.5 * p.l, 0.5 * p.l})
        for (const auto& [node, w] : test::real_weights(mesh, test::box_at(p.x + dx, p.y + dy, 0.5 * p.l))) {
          parent[node].s -= 0.25 * w.s;
          parent[node].gx -= 0.25 * w.gx;
          parent[node].gy -= 0.25 * w.gy;
        }
    for (const auto& [node, left] : parent) {
      EXPECT_NEAR(left.s, 0.0, 1e-14);
      EXPECT_NEAR(left.gx, 0.0, 1e-13); // per metre, of the order of 4
      EXPECT_NEAR(left.gy, 0.0, 1e-13);
    }
  }
}

} // namespace
} // namespace tremolo::mpm_domain
