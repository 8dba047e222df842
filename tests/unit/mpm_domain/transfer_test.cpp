// Conservation between particles and grid, and what rigid motions must leave alone.

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/affine_velocity.hpp"
#include "tests/support/box_run.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tremolo::mpm_domain {
namespace {

struct Totals {
  double mass = 0.0;
  Vector momentum;
  double spin = 0.0; ///< angular momentum about the origin
};

Totals grid_totals(const Domain& domain) {
  Totals total;
  const Grid& grid = domain.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t n = grid.index(i, j);
      total.mass += grid.mass[n];
      total.momentum.x += grid.momentum_x[n];
      total.momentum.y += grid.momentum_y[n];
      total.spin += (grid.x0 + i * grid.h) * grid.momentum_y[n] - (grid.y0 + j * grid.h) * grid.momentum_x[n];
    }
  return total;
}

/// To be shuffled.
Domain shuffled_box(Transfer transfer, ParticleBoxes boxes = ParticleBoxes::fixed) {
  Spec spec = test_support::elastic_box(6.0, 5.0, 0.5);
  spec.scheme.transfer = transfer;
  spec.boxes = boxes;
  return Domain(spec);
}

/// Particles at random positions with random velocities and, where they follow the soil, boxes of any size.
void shuffle(Domain& domain) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> position(-0.2, 0.2);
  std::normal_distribution<double> speed;
  std::uniform_real_distribution<double> half_side(0.02, 0.6);
  Particles& p = domain.sets.front();
  for (std::vector<double>* moment : {&p.box_xx, &p.box_yy})
    std::ranges::generate(*moment, [&] { return std::pow(half_side(random), 2); });
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.x[k] += position(random);
    p.y[k] += position(random);
    p.vx[k] = speed(random);
    p.vy[k] = speed(random);
    if (p.traits.affine) {
      p.bxx[k] = 0.05 * speed(random);
      p.bxy[k] = 0.05 * speed(random);
      p.byx[k] = 0.05 * speed(random);
      p.byy[k] = 0.05 * speed(random);
    }
  }
  sort_by_cell(p, domain.tiles, 0, domain.tiles.count());
}

/// Velocities of the nodes that no force has changed.
void find_unforced_velocities(Domain& domain) {
  grid_velocities(domain, domain.soil_rows);
  domain.grid.vx_after = domain.grid.vx_before;
  domain.grid.vy_after = domain.grid.vy_before;
}

class TransferWith : public testing::TestWithParam<ParticleBoxes> {};

TEST_P(TransferWith, ScatterConservesMassMomentumAndAngularMomentum) {
  Domain domain = shuffled_box(Transfer::apic, GetParam());
  shuffle(domain);
  scatter(domain, ScatterPart::both);
  const Particles& p = domain.sets.front();
  Totals expected;
  for (std::size_t k = 0; k < p.size(); ++k) {
    expected.mass += p.mass[k];
    expected.momentum.x += p.mass[k] * p.vx[k];
    expected.momentum.y += p.mass[k] * p.vy[k];
    expected.spin += p.mass[k] * (p.x[k] * p.vy[k] - p.y[k] * p.vx[k] + p.byx[k] - p.bxy[k]);
  }
  const Totals grid = grid_totals(domain);
  const double scale = expected.mass; // speeds are of order 1 m/s
  EXPECT_NEAR(grid.mass, expected.mass, 1e-12 * scale);
  EXPECT_NEAR(grid.momentum.x, expected.momentum.x, 1e-12 * scale);
  EXPECT_NEAR(grid.momentum.y, expected.momentum.y, 1e-12 * scale);
  EXPECT_NEAR(grid.spin, expected.spin, 1e-11 * scale);
}

/// The transfers again, one particle and node after the other.
struct Node {
  std::size_t index;
  double s, gx, gy; ///< S, dS/dx, dS/dy
  double dx, dy;    ///< node minus particle, m
};

std::vector<Node> nodes_of(const Domain& domain, const Particles& p, std::size_t k) {
  const Grid& grid = domain.grid;
  const double x = p.x[k];
  const double y = p.y[k];
  const Vector half = half_sides(p, k);
  const Weights wx = cell_weights(x, domain.x_axis(), half.x);
  const Weights wy = cell_weights(y, domain.y_axis(), half.y);
  std::vector<Node> nodes;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i)
      nodes.push_back({grid.index(wx.base + i, wy.base + j), wx.s[i] * wy.s[j], wx.g[i] * wy.s[j],
                       wx.s[i] * wy.g[j], grid.x0 + (wx.base + i) * grid.h - x,
                       grid.y0 + (wy.base + j) * grid.h - y});
  return nodes;
}

TEST_P(TransferWith, ScatterIsTheSumOverParticles) {
  Domain domain = shuffled_box(Transfer::apic, GetParam());
  domain.spec.gravity = 9.81;
  shuffle(domain);
  Particles& p = domain.sets.front();
  std::mt19937 random(6);
  std::normal_distribution<double> stress(0.0, 1e5);
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.sxx[k] = stress(random);
    p.syy[k] = stress(random);
    p.sxy[k] = stress(random);
  }
  scatter(domain, ScatterPart::both);
  Grid expected;
  for (NodeField* field :
       {&expected.mass, &expected.momentum_x, &expected.momentum_y, &expected.force_x, &expected.force_y})
    field->resize(domain.grid.size());
  for (std::size_t k = 0; k < p.size(); ++k) {
    const std::vector<Node> nodes = nodes_of(domain, p, k);
    Vector d;
    for (const Node& n : nodes)
      d = {d.x + n.s * n.dx * n.dx, d.y + n.s * n.dy * n.dy};
    for (const Node& n : nodes) {
      const double m = n.s * p.mass[k];
      expected.mass[n.index] += m;
      expected.momentum_x[n.index] += m * (p.vx[k] + p.bxx[k] / d.x * n.dx + p.bxy[k] / d.y * n.dy);
      expected.momentum_y[n.index] += m * (p.vy[k] + p.byx[k] / d.x * n.dx + p.byy[k] / d.y * n.dy);
      expected.force_x[n.index] -= p.volume[k] * (n.gx * p.sxx[k] + n.gy * p.sxy[k]);
      expected.force_y[n.index] -= p.volume[k] * (n.gx * p.sxy[k] + n.gy * p.syy[k]) + m * 9.81;
    }
  }
  for (std::size_t n = 0; n < domain.grid.size(); ++n) {
    EXPECT_NEAR(domain.grid.mass[n], expected.mass[n], 1e-11);
    EXPECT_NEAR(domain.grid.momentum_x[n], expected.momentum_x[n], 1e-10);
    EXPECT_NEAR(domain.grid.momentum_y[n], expected.momentum_y[n], 1e-10);
    EXPECT_NEAR(domain.grid.force_x[n], expected.force_x[n], 1e-8);
    EXPECT_NEAR(domain.grid.force_y[n], expected.force_y[n], 1e-8);
  }
}

TEST_P(TransferWith, GatherIsTheSumOverNodes) {
  for (const Transfer transfer : {Transfer::apic, Transfer::flip}) {
    Domain domain = shuffled_box(transfer, GetParam());
    shuffle(domain);
    Grid& grid = domain.grid;
    std::mt19937 random(12);
    std::normal_distribution<double> speed;
    for (NodeField* field : {&grid.vx_before, &grid.vy_before, &grid.vx_after, &grid.vy_after})
      std::ranges::generate(*field, [&] { return speed(random); });
    const Particles before = domain.sets.front();
    const double dt = 1e-4;
    gather(domain, dt, {.velocity = true, .position = true, .strain = true});
    const Particles& p = domain.sets.front();
    const materials::Elasticity& soil = materials::elasticity(p.law);
    for (std::size_t k = 0; k < p.size(); ++k) {
      Vector v, v_new, x_moment, y_moment;           // moments: of the x and y component with dx and dy
      double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0; // of A, the gradient times dt
      for (const Node& n : nodes_of(domain, before, k)) {
        const Vector u = grid.velocity_before(n.index);
        const Vector w = grid.velocity_after(n.index);
        v = {v.x + n.s * u.x, v.y + n.s * u.y};
        v_new = {v_new.x + n.s * w.x, v_new.y + n.s * w.y};
        x_moment = {x_moment.x + n.s * w.x * n.dx, x_moment.y + n.s * w.x * n.dy};
        y_moment = {y_moment.x + n.s * w.y * n.dx, y_moment.y + n.s * w.y * n.dy};
        xx += dt * n.gx * w.x;
        xy += dt * n.gy * w.x;
        yx += dt * n.gx * w.y;
        yy += dt * n.gy * w.y;
      }
      // A - A^2/2 and det(I + A), which the volume meets to second order.
      const double exx = xx - 0.5 * (xx * xx + xy * yx);
      const double eyy = yy - 0.5 * (yy * yy + xy * yx);
      const double gxy = xy + yx - 0.5 * (xx + yy) * (xy + yx);
      EXPECT_NEAR(p.x[k], before.x[k] + dt * v_new.x, 1e-14);
      if (transfer == Transfer::apic) {
        EXPECT_NEAR(p.vy[k], v_new.y, 1e-13);
        EXPECT_NEAR(p.bxx[k], x_moment.x, 1e-13);
        EXPECT_NEAR(p.bxy[k], x_moment.y, 1e-13);
        EXPECT_NEAR(p.byx[k], y_moment.x, 1e-13);
        EXPECT_NEAR(p.byy[k], y_moment.y, 1e-13);
      } else {
        EXPECT_NEAR(p.vx[k], before.vx[k] + v_new.x - v.x, 1e-13);
        EXPECT_NEAR(p.vy[k], before.vy[k] + v_new.y - v.y, 1e-13);
      }
      EXPECT_NEAR(p.volume[k] / before.volume[k], (1.0 + xx) * (1.0 + yy) - xy * yx, 1e-9); // of A of 1e-3
      EXPECT_NEAR(p.sxx[k], soil.p_modulus() * exx + soil.lame() * eyy, 1e-6);              // of some 1e4 Pa
      EXPECT_NEAR(p.sxy[k], soil.shear_modulus() * gxy, 1e-6);
      if (!p.has_own_boxes())
        continue;
      Eigen::Matrix2d f, box;
      f << 1.0 + xx, xy, yx, 1.0 + yy;
      box << before.box_xx[k], before.box_xy[k], before.box_xy[k], before.box_yy[k];
      const Eigen::Matrix2d followed = f * box * f.transpose();
      EXPECT_NEAR(p.box_xx[k], followed(0, 0), 1e-15);
      EXPECT_NEAR(p.box_xy[k], followed(0, 1), 1e-15);
      EXPECT_NEAR(p.box_yy[k], followed(1, 1), 1e-15);
    }
  }
}

TEST_P(TransferWith, ApicGatherKeepsMomentumAndAngularMomentum) {
  Domain domain = shuffled_box(Transfer::apic, GetParam());
  shuffle(domain);
  scatter(domain, ScatterPart::motion);
  find_unforced_velocities(domain);
  const Totals before = grid_totals(domain);
  // Particles move between the transfers, across the faces of cells too, and boxes follow their strain.
  gather(domain, 0.05, {.velocity = true, .position = true, .strain = true});
  scatter(domain, ScatterPart::motion);
  const Totals after = grid_totals(domain);
  EXPECT_NEAR(after.momentum.x, before.momentum.x, 1e-11 * before.mass);
  EXPECT_NEAR(after.momentum.y, before.momentum.y, 1e-11 * before.mass);
  EXPECT_NEAR(after.spin, before.spin, 1e-10 * before.mass);
}

TEST_P(TransferWith, InternalForcesSumToZeroAndGravityToTheWeight) {
  Spec spec = test_support::elastic_box(6.0, 5.0, 0.5);
  spec.gravity = 9.81;
  spec.boxes = GetParam();
  Domain domain(spec);
  shuffle(domain);
  Particles& p = domain.sets.front();
  std::mt19937 random(5);
  std::normal_distribution<double> stress(0.0, 1e5);
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.sxx[k] = stress(random);
    p.syy[k] = stress(random);
    p.sxy[k] = stress(random);
  }
  scatter(domain, ScatterPart::force);
  Vector sum;
  for (std::size_t n = 0; n < domain.grid.size(); ++n) {
    sum.x += domain.grid.force_x[n];
    sum.y += domain.grid.force_y[n];
  }
  const double weight = 1700.0 * 30.0 * 9.81;
  EXPECT_NEAR(sum.x, 0.0, 1e-9 * weight);
  EXPECT_NEAR(sum.y, -weight, 1e-9 * weight);
}

INSTANTIATE_TEST_SUITE_P(Boxes, TransferWith, testing::Values(ParticleBoxes::fixed, ParticleBoxes::deforming),
                         [](const auto& of) {
                           return of.param == ParticleBoxes::fixed ? "Fixed" : "Deforming";
                         });

/// Grid velocities of a turn by theta are A/dt with A = R - I. What is left of A - A^2/2 is theta^4/4; A
/// alone would be a contraction by theta^2/2.
TEST(Transfer, RigidRotationCausesNoStress) {
  Domain domain = shuffled_box(Transfer::apic);
  Particles& p = domain.sets.front();
  const double dt = 1e-3;
  const double theta = 1e-2;
  const double shrink = (std::cos(theta) - 1.0) / dt; // 1/s
  const double spin = std::sin(theta) / dt;           // rad/s
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.vx[k] = shrink * p.x[k] - spin * p.y[k];
    p.vy[k] = spin * p.x[k] + shrink * p.y[k];
    test_support::set_affine_velocity(domain, p, k, {.xx = shrink, .xy = -spin, .yx = spin, .yy = shrink});
  }
  scatter(domain, ScatterPart::both);
  find_unforced_velocities(domain);
  const Particles before = p; // at the positions of whose weights B is taken
  gather(domain, dt, {.velocity = true, .position = true, .strain = true});
  const double stress = 2.0 * materials::elasticity(p.law).p_modulus() * std::pow(theta, 4) / 4.0; // Pa
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Vector d = test_support::second_moments(domain, before, k);
    EXPECT_NEAR(p.sxx[k], 0.0, stress);
    EXPECT_NEAR(p.syy[k], 0.0, stress);
    EXPECT_NEAR(p.sxy[k], 0.0, 1e-3 * stress);
    EXPECT_NEAR(p.volume[k], before.volume[k], 1e-8 * before.volume[k]);
    EXPECT_NEAR(p.byx[k], spin * d.x, 1e-12 * spin);
    EXPECT_NEAR(p.bxy[k], -spin * d.y, 1e-12 * spin);
  }
}

TEST(Sort, AParticleOutsideTheGridIsNamedWithItsPlace) {
  Domain domain = shuffled_box(Transfer::flip);
  domain.sets.front().x[0] = 1e3;
  try {
    sort_by_cell(domain.sets.front(), domain.tiles, 0, domain.tiles.count());
    FAIL() << "a particle outside the grid was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("has left the grid: x = 1000 m"), std::string::npos)
        << error.what();
  }
}

} // namespace
} // namespace tremolo::mpm_domain
