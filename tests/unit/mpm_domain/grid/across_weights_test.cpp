// Weights by the table of cells, of boxes anywhere within the reach that their cells were found for, next to
// the exact box averages told to real nodes.

#include "mpm_domain/grid/across_weights.hpp"
#include "tests/unit/mpm_domain/graded/real_weights.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain {
namespace {

constexpr double margin = 0.0625; // m

mesh::Rectangle widened(const mesh::Rectangle& box, double by) {
  return {box.x_min - by, box.y_min - by, box.x_max + by, box.y_max + by};
}

/// Weights of all boxes that particles have after they have moved, most of them no squares any more.
struct Moved {
  GradedMesh mesh = test::l_shaped_mesh();
  BasisCells cells;
  AcrossWeights weights;
  std::vector<mesh::Rectangle> boxes;

  Moved() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> way(-margin, margin);
    weights.restart(0);
    for (const test::Particle& p : test::random_particles()) {
      const mesh::Rectangle box = test::box_at(p.x, p.y, p.l);
      weights.expect(mesh, cells, widened(box, margin));
      boxes.push_back({box.x_min + way(random), box.y_min + way(random), box.x_max + way(random),
                       box.y_max + way(random)});
    }
    weights.settle(cells);
    for (const mesh::Rectangle& box : boxes)
      weights.add(cells, box);
  }
};

TEST(AcrossWeights, AreTheBoxAveragesInTermsOfRealNodes) {
  const Moved moved;
  ASSERT_EQ(moved.weights.end(), moved.boxes.size());
  for (std::size_t k = 0; k < moved.boxes.size(); ++k) {
    test::RealWeights expected = test::real_weights(moved.mesh, moved.boxes[k]);
    for (const FourWeights& w : moved.weights.of(k))
      for (std::size_t lane = 0; lane < 4; ++lane) {
        test::RealWeight& left = expected[w.node[lane]];
        left.s -= w.s[lane];
        left.gx -= w.gx[lane];
        left.gy -= w.gy[lane];
      }
    for (const auto& [node, left] : expected) {
      EXPECT_NEAR(left.s, 0.0, 1e-14);
      EXPECT_NEAR(left.gx, 0.0, 1e-13);
      EXPECT_NEAR(left.gy, 0.0, 1e-13);
    }
  }
}

TEST(AcrossWeights, KnowTheirSecondMoments) {
  const Moved moved;
  for (std::size_t k = 0; k < moved.boxes.size(); ++k) {
    const mesh::Rectangle& box = moved.boxes[k];
    double dxx = 0.0, dyy = 0.0;
    for (const auto& [node, w] : test::real_weights(moved.mesh, box)) {
      const double dx = w.x - 0.5 * (box.x_min + box.x_max);
      const double dy = w.y - 0.5 * (box.y_min + box.y_max);
      dxx += w.s * dx * dx;
      dyy += w.s * dy * dy;
    }
    EXPECT_NEAR(moved.weights.per_moments(k).x * dxx, 1.0, 1e-12);
    EXPECT_NEAR(moved.weights.per_moments(k).y * dyy, 1.0, 1e-12);
  }
}

/// What is found anew on the way, as a run that is resumed does, must not change a bit.
TEST(AcrossWeights, DoNotDependOnWhereTheirCellsWereFound) {
  Moved moved;
  const AcrossWeights before = moved.weights;
  moved.weights.restart(0);
  for (const mesh::Rectangle& box : moved.boxes)
    moved.weights.expect(moved.mesh, moved.cells, widened(box, margin));
  moved.weights.settle(moved.cells);
  for (const mesh::Rectangle& box : moved.boxes)
    moved.weights.add(moved.cells, box);
  for (std::size_t k = 0; k < moved.boxes.size(); ++k) {
    ASSERT_EQ(moved.weights.of(k).size(), before.of(k).size());
    for (std::size_t n = 0; n < before.of(k).size(); ++n)
      for (std::size_t lane = 0; lane < 4; ++lane) {
        EXPECT_EQ(moved.weights.of(k)[n].node[lane], before.of(k)[n].node[lane]);
        EXPECT_EQ(moved.weights.of(k)[n].s[lane], before.of(k)[n].s[lane]);
        EXPECT_EQ(moved.weights.of(k)[n].gx[lane], before.of(k)[n].gx[lane]);
      }
  }
}

} // namespace
} // namespace tremolo::mpm_domain
