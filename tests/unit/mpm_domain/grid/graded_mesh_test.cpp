#include "tests/unit/mpm_domain/graded/real_weights.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo::mpm_domain {
namespace {

/// The row of P of the node at (level, i, j), as weights by place "x,y".
std::map<std::pair<double, double>, double> tie_of(const GradedMesh& mesh, int level, int i, int j) {
  std::map<std::pair<double, double>, double> shares;
  for (std::size_t r = 0; r < mesh.prolongation().tied_count(); ++r)
    if (mesh.prolongation().tied(r) == mesh.node(level, i, j))
      for (const Share& share : mesh.prolongation().row(r)) {
        test::RealWeight at;
        test::position(mesh, share.node, at);
        shares[{at.x, at.y}] += share.weight;
      }
  return shares;
}

using Ties = std::map<std::pair<double, double>, double>;

/// Fine cells left of x = 1: the root cell [1, 2] x [1, 2] has a hanging node at (1, 1.5).
TEST(GradedMesh, TiesAreMeansOfEdgesAndOfTheAxisWithHangingNodes) {
  const std::vector<mesh::Refinement> boxes{{{0.0, 0.0, 1.0, 4.0}, 1}};
  const GradedMesh mesh({.h = 1.0, .nx = 4, .ny = 4}, boxes);
  EXPECT_TRUE(is_split(mesh.tree(), {0, 1, 1}));
  EXPECT_FALSE(is_split(mesh.tree(), {0, 2, 1}));
  EXPECT_EQ(tie_of(mesh, 1, 2, 3), Ties{}); // hanging: real
  EXPECT_EQ(tie_of(mesh, 1, 4, 3), (Ties{{{2.0, 1.0}, 0.5}, {{2.0, 2.0}, 0.5}}));
  EXPECT_EQ(tie_of(mesh, 1, 3, 2), (Ties{{{1.0, 1.0}, 0.5}, {{2.0, 1.0}, 0.5}}));
  EXPECT_EQ(tie_of(mesh, 1, 3, 3), (Ties{{{1.0, 1.5}, 0.5}, {{2.0, 1.0}, 0.25}, {{2.0, 2.0}, 0.25}}));
  EXPECT_EQ(tie_of(mesh, 1, 4, 4), (Ties{{{2.0, 2.0}, 1.0}})); // a corner of root cells alone
  EXPECT_EQ(tie_of(mesh, 0, 1, 1), Ties{});                    // unused: its cells are cut or split
}

/// Fine cells left of and below the root cell [1, 2] x [1, 2]: its centre is the mean of all four mid-edges.
TEST(GradedMesh, ACentreBetweenTwoAxesIsTheMeanOfAllMidEdges) {
  const std::vector<mesh::Refinement> boxes{{{0.0, 0.0, 1.0, 4.0}, 1}, {{0.0, 0.0, 4.0, 1.0}, 1}};
  const GradedMesh mesh({.h = 1.0, .nx = 4, .ny = 4}, boxes);
  EXPECT_EQ(tie_of(mesh, 1, 3, 3), (Ties{{{1.0, 1.5}, 0.25},
                                         {{1.5, 1.0}, 0.25},
                                         {{2.0, 1.0}, 0.125},
                                         {{2.0, 2.0}, 0.25},
                                         {{1.0, 2.0}, 0.125}}));
}

TEST(GradedMesh, RowsOfTheProlongationReproduceLinearFields) {
  const GradedMesh mesh = test::l_shaped_mesh();
  ASSERT_GT(mesh.prolongation().tied_count(), 100U);
  for (std::size_t r = 0; r < mesh.prolongation().tied_count(); ++r) {
    test::RealWeight tied;
    test::position(mesh, mesh.prolongation().tied(r), tied);
    double sum = 0.0, x = 0.0, y = 0.0;
    for (const Share& share : mesh.prolongation().row(r)) {
      test::RealWeight at;
      test::position(mesh, share.node, at);
      EXPECT_GT(share.weight, 0.0);
      sum += share.weight;
      x += share.weight * at.x;
      y += share.weight * at.y;
    }
    EXPECT_NEAR(sum, 1.0, 1e-15);
    EXPECT_NEAR(x, tied.x, 1e-14);
    EXPECT_NEAR(y, tied.y, 1e-14);
  }
}

TEST(GradedMesh, RealNodesAreTiedToNothing) {
  const GradedMesh mesh = test::l_shaped_mesh();
  std::vector<bool> tied(mesh.node_count(), false);
  for (std::size_t r = 0; r < mesh.prolongation().tied_count(); ++r)
    tied[mesh.prolongation().tied(r)] = true;
  for (std::size_t r = 0; r < mesh.prolongation().tied_count(); ++r)
    for (const Share& share : mesh.prolongation().row(r))
      EXPECT_FALSE(tied[share.node]);
}

/// At random points, on the edges of cells, and beyond the mesh.
TEST(GradedMesh, ThePartAtAPointIsTheOneThatABoxWithoutSizeBelongsTo) {
  const GradedMesh mesh = test::l_shaped_mesh();
  const mesh::Roots& roots = mesh.tree().roots();
  const double finest = mesh.tree().size(mesh.tree().finest() + 1);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> along(-0.1, 1.1);
  int split = 0;
  for (int k = 0; k < 20000; ++k) {
    double x = roots.x0 + along(random) * roots.nx * roots.h;
    double y = roots.y0 + along(random) * roots.ny * roots.h;
    if (k % 2 == 0)
      x = roots.x0 + std::round((x - roots.x0) / finest) * finest;
    if (k % 3 == 0)
      y = roots.y0 + std::round((y - roots.y0) / finest) * finest;
    std::optional<mesh::Cell> expected;
    mesh.for_parts({x, y, x, y}, [&](const mesh::Cell& cell, const mesh::Rectangle&) {
      EXPECT_FALSE(expected);
      expected = cell;
    });
    EXPECT_EQ(mesh.part_at(x, y), expected) << x << ", " << y;
    split += expected && !mesh.tree().exists(*expected) ? 1 : 0;
  }
  EXPECT_GT(split, 100);
}

TEST(GradedMesh, AUniformMeshHasOneLatticeAndNoTies) {
  const GradedMesh mesh({.h = 0.5, .nx = 4, .ny = 3}, {});
  ASSERT_EQ(mesh.lattices().size(), 1U);
  EXPECT_EQ(mesh.lattices().front().nx, 5);
  EXPECT_EQ(mesh.lattices().front().ny, 4);
  EXPECT_EQ(mesh.prolongation().tied_count(), 0U);
}

TEST(Prolongation, RestrictIsItsTranspose) {
  const GradedMesh mesh = test::l_shaped_mesh();
  std::mt19937 random(1);
  std::normal_distribution<double> any;
  std::vector<double> v(mesh.node_count()), f(mesh.node_count());
  for (std::size_t n = 0; n < v.size(); ++n) {
    v[n] = any(random);
    f[n] = any(random);
  }
  const auto dot = [&] {
    double sum = 0.0;
    for (std::size_t n = 0; n < v.size(); ++n)
      sum += v[n] * f[n];
    return sum;
  };
  mesh.prolongation().prolong(v);
  const double before = dot();
  mesh.prolongation().restrict(f);
  EXPECT_NEAR(dot(), before, 1e-12 * static_cast<double>(v.size()));
}

} // namespace
} // namespace tremolo::mpm_domain
