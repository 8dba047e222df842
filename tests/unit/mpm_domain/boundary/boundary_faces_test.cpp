#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/clocks/clock_nodes.hpp"
#include "mpm_domain/clocks/ticks.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/lumped_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {
namespace {

Spec box_spec() {
  return test_support::elastic_box(6.0, 4.0, 1.0);
}

TEST(BoundaryFaces, CoverTheThreeSidesOnce) {
  const Domain domain(box_spec());
  double left = 0.0, right = 0.0, base = 0.0;
  for (const BoundaryFace& face : domain.boundary.faces()) {
    (face.side == Side::left ? left : face.side == Side::right ? right : base) += face.length;
    if (face.side == Side::left) {
      EXPECT_DOUBLE_EQ(face.position.x, 0.0);
      EXPECT_DOUBLE_EQ(face.ground.normal.x, -1.0);
    }
    if (face.side == Side::base) {
      EXPECT_DOUBLE_EQ(face.position.y, -4.0);
      EXPECT_DOUBLE_EQ(face.ground.normal.y, -1.0);
    }
  }
  EXPECT_DOUBLE_EQ(left, 4.0);
  EXPECT_DOUBLE_EQ(right, 4.0);
  EXPECT_DOUBLE_EQ(base, 6.0);
}

/// The domain and its faces after the particles were shifted by (dx, dy).
struct Shifted {
  Domain domain;
  std::vector<FaceWeights> weights;

  Shifted(double dx, double dy) : domain(box_spec()) {
    for (Particles& set : domain.sets) {
      for (std::size_t k = 0; k < set.size(); ++k) {
        set.x[k] += dx;
        set.y[k] += dy;
      }
      sort_by_cell(set, domain.tiles, 0, domain.tiles.count());
    }
    for (const BoundaryFace& face : domain.boundary.faces())
      face_weights(domain, face, weights.emplace_back());
  }
};

constexpr double dt = 1e-3; // s

/// Gives the nodes what the faces exert in a free field.
void load(Domain& domain, const FreeFieldSource& source) {
  Step step(domain, domain.energy, 0.0);
  step.ticks.set_step(dt, dt);
  domain.boundary.read_soil(domain);
  domain.boundary.exchange(step, source);
  domain.boundary.apply(step);
}

class ShiftedFaces : public testing::TestWithParam<Vector> {};

TEST_P(ShiftedFaces, WeightsSumToOne) {
  const Shifted s(GetParam().x, GetParam().y);
  for (const FaceWeights& weights : s.weights) {
    double sum = 0.0;
    for (const FaceWeight& weight : weights) {
      sum += weight.w;
      EXPECT_GE(weight.w, -1e-12);
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

// A uniform stress and its own tractions leave no force at any node away from the free surface, however the
// boundary cuts its cells.
TEST_P(ShiftedFaces, TractionsBalanceAUniformStress) {
  Shifted s(GetParam().x, GetParam().y);
  const double sxx = -3e4, syy = -1e5, sxy = 2e4;
  for (Particles& set : s.domain.sets) {
    set.sxx.assign(set.size(), sxx);
    set.syy.assign(set.size(), syy);
    set.sxy.assign(set.size(), sxy);
  }
  scatter(s.domain, ScatterPart::force);
  for (BoundaryFace& face : s.domain.boundary.faces())
    face.ground.impedance_p = face.ground.impedance_s = 0.0; // of the free field, its stress alone
  load(s.domain, [&](long, double, auto, std::span<eq6::FreeField> field) {
    std::ranges::fill(field, eq6::FreeField{{}, {sxx, syy, sxy}});
  });
  const Grid& grid = s.domain.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      if (grid.y0 + j * grid.h > -1.5)
        continue;
      const std::size_t n = grid.index(i, j);
      EXPECT_NEAR(grid.force_x[n], 0.0, 1e-12 * 1e5) << "node " << i << ", " << j;
      EXPECT_NEAR(grid.force_y[n], 0.0, 1e-12 * 1e5) << "node " << i << ", " << j;
    }
}

INSTANTIATE_TEST_SUITE_P(Shifts, ShiftedFaces,
                         testing::Values(Vector{0.0, 0.0}, Vector{1e-9, -1e-9}, Vector{0.13, -0.29},
                                         Vector{-0.8, 0.4}));

// -C (v+ + v-)/2 with the same impedance as the soil behind it: whatever the mass of a node, it stays
// bounded, by 2 |f|/C with the dashpots lumped. Each of the three steps that make them consistent
// (consistent_dashpots.hpp) adds no more than the first solution once again.
TEST(Dashpot, ANodeWithHardlyAnyMassIsBoundedByItsDashpot) {
  const double traction = 1e4; // Pa, upwards on every face
  const auto fastest = [&](const auto& load_faces) {
    Shifted s(0.0, -1e-7); // the base sticks out below a row of nodes by a ten-millionth of a cell
    scatter(s.domain, ScatterPart::both);
    grid_velocities(s.domain, s.domain.soil_rows);
    load_faces(s.domain);
    update_grid(s.domain, dt, s.domain.soil_rows);
    double speed = 0.0;
    for (const double v : s.domain.grid.vy_after)
      speed = std::max(speed, std::abs(v));
    return speed;
  };
  const double lumped = fastest([&](Domain& domain) {
    test_support::add_lumped_faces(domain, [&](const BoundaryFace&) { return Vector{0.0, traction}; });
  });
  const double consistent = fastest([&](Domain& domain) {
    load(domain, [&](long, double, auto, std::span<eq6::FreeField> field) {
      for (std::size_t f = 0; f < field.size(); ++f) {
        const Vector n = domain.boundary.faces()[f].ground.normal;
        field[f] = {{}, {0.0, traction * n.y, traction * n.x}};
      }
    });
  });
  const double bound = 2.0 * traction / Domain(box_spec()).boundary.faces().front().ground.impedance_s;
  EXPECT_GT(lumped, 0.0);
  EXPECT_LT(lumped, bound);
  EXPECT_GT(consistent, 0.0);
  EXPECT_LT(consistent, 4.0 * bound);
}

} // namespace
} // namespace tremolo::mpm_domain
