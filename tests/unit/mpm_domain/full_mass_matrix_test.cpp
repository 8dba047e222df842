// FMPM(k): against dense matrices, and what it keeps and takes away in a transfer to the particles and back.

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/step/full_mass_matrix.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/for_particles.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/particle_energy.hpp"
#include "tests/unit/mpm_domain/graded/real_weights.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr double density = 1700.0; // kg/m3, of elastic_box

Spec fmpm_box(int order) {
  Spec spec = test_support::elastic_box(4.0, 3.0, 0.5);
  spec.scheme.transfer = Transfer::fmpm;
  spec.scheme.fmpm_order = order;
  return spec;
}

Spec periodic_box(int order) {
  Spec spec = fmpm_box(order);
  spec.sides = mpm_domain::Sides::periodic;
  return spec;
}

/// Three levels, with hanging nodes and a corner.
Spec graded_box(int order) {
  Spec spec = test_support::elastic_box(6.0, 6.0, 1.0);
  spec.refine = {{{2.0, -4.0, 4.0, 0.0}, 1}, {{2.0, -2.0, 3.0, -1.0}, 2}};
  spec.scheme.transfer = Transfer::fmpm;
  spec.scheme.fmpm_order = order;
  return spec;
}

using test_support::for_particles;

/// Random velocities of particles that stand up to 0.4 of their size beside their places.
void shuffle(Domain& domain) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-0.4, 0.4);
  std::normal_distribution<double> speed;
  for_particles(domain, [&](Particles& p, std::size_t k) {
    p.x[k] += place(random) * p.half_size;
    p.y[k] += place(random) * p.half_size;
    p.vx[k] = speed(random);
    p.vy[k] = speed(random);
  });
  sort_particles(domain);
}

/// The mean of the hat function of a node over [x - l, x + l].
double mean_of_hat(double node, double h, double x, double l) {
  const auto hat_integral = [&](double to) { // of the hat from -1 to `to`, in cells from the node
    const double t = std::clamp(to, -1.0, 1.0);
    return t < 0.0 ? 0.5 * (1.0 + t) * (1.0 + t) : 1.0 - 0.5 * (1.0 - t) * (1.0 - t);
  };
  return (hat_integral((x + l - node) / h) - hat_integral((x - l - node) / h)) * h / (2.0 * l);
}

/// S of a particle by node; images of a period are the nodes that they stand for.
std::map<std::size_t, double> weights_of(const Domain& domain, const Particles& p, std::size_t k) {
  std::map<std::size_t, double> weights;
  if (domain.mesh) {
    for (const auto& [node, w] : test::real_weights(*domain.mesh, box_of(p, k)))
      weights[node] = w.s;
    return weights;
  }
  const Grid& grid = domain.grid;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const double s = mean_of_hat(grid.x0 + i * grid.h, grid.h, p.x[k], p.half_size) *
                       mean_of_hat(grid.y0 + j * grid.h, grid.h, p.y[k], p.half_size);
      if (s > 0.0)
        weights[grid.index(grid.real_column(i), j)] += s;
    }
  return weights;
}

/// S (particles x nodes), the particles' masses and the nodes that they touch, of a whole domain.
struct Dense {
  Eigen::MatrixXd s;
  Eigen::VectorXd particle_mass, node_mass;
  std::vector<std::size_t> nodes;

  explicit Dense(Domain& domain) : particle_mass(static_cast<Eigen::Index>(domain.particle_count())) {
    std::vector<std::map<std::size_t, double>> rows;
    std::map<std::size_t, Eigen::Index> column_of;
    for_particles(domain, [&](Particles& p, std::size_t k) {
      particle_mass[static_cast<Eigen::Index>(rows.size())] = p.mass[k];
      for (const auto& [node, weight] : rows.emplace_back(weights_of(domain, p, k)))
        if (column_of.try_emplace(node, static_cast<Eigen::Index>(nodes.size())).second)
          nodes.push_back(node);
    });
    s.setZero(particle_mass.size(), static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t row = 0; row < rows.size(); ++row)
      for (const auto& [node, weight] : rows[row])
        s(static_cast<Eigen::Index>(row), column_of[node]) = weight;
    node_mass = s.transpose() * particle_mass;
  }

  /// F v = M^-1 S^T m S v
  Eigen::VectorXd read_and_told(const Eigen::VectorXd& v) const {
    return (s.transpose() * (particle_mass.asDiagonal() * (s * v))).cwiseQuotient(node_mass);
  }

  /// sum_{j<k} (I - F)^j v
  Eigen::VectorXd summed(const Eigen::VectorXd& v, int k) const {
    Eigen::VectorXd term = v;
    Eigen::VectorXd sum = v;
    for (int j = 1; j < k; ++j) {
      term -= read_and_told(term);
      sum += term;
    }
    return sum;
  }

  Eigen::VectorXd of(const NodeField& field) const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t n = 0; n < nodes.size(); ++n)
      values[static_cast<Eigen::Index>(n)] = field[nodes[n]];
    return values;
  }
};

/// A random velocity after the update.
void set_random_velocity(Domain& domain) {
  std::mt19937 random(3);
  std::normal_distribution<double> speed;
  Grid& grid = domain.grid;
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const bool full = grid.mass[n] > empty_mass(domain);
    grid.vx_new[n] = full ? speed(random) : 0.0;
    grid.vy_new[n] = full ? speed(random) : 0.0;
  }
  if (domain.has_tied_nodes())
    copy_to_tied(domain, {&grid.vx_new, &grid.vy_new});
}

struct Mesh {
  std::string name;
  Spec (*spec)(int order);
};

class FullMass : public testing::TestWithParam<Mesh> {};

TEST_P(FullMass, IsTheSumOfPowersOfDenseMatrices) {
  for (const int order : {2, 3, 10}) {
    Domain domain(GetParam().spec(order));
    shuffle(domain);
    scatter(domain, ScatterPart::motion);
    grid_velocities(domain);
    set_random_velocity(domain);
    const Dense dense(domain);
    const NodeField lumped = domain.grid.vx_new;
    const Eigen::VectorXd exact = dense.summed(dense.of(lumped), order);
    const Eigen::VectorXd read = dense.s * exact;
    FullMassMatrix matrix(order);
    matrix.solve(domain);
    const Eigen::VectorXd error = dense.of(domain.grid.vx_new) - exact;
    const double cell = density * std::pow(domain.finest_lattice().h, 2);
    EXPECT_LT(error.cwiseProduct(dense.node_mass.cwiseMin(cell) / cell).cwiseAbs().maxCoeff(), 1e-12);
    gather(domain, 1e-3, {.velocity = true});
    Eigen::Index next = 0;
    double worst = 0.0;
    for_particles(domain, [&](Particles& p, std::size_t k) {
      worst = std::max(worst, std::abs(p.vx[k] - read[next++]));
    });
    EXPECT_LT(worst, 1e-12);
    matrix.restore(domain);
    EXPECT_EQ(domain.grid.vx_new, lumped);
  }
}

Vector momentum(Domain& domain) {
  Vector sum;
  for_particles(domain, [&](Particles& p, std::size_t k) {
    sum.x += p.mass[k] * p.vx[k];
    sum.y += p.mass[k] * p.vy[k];
  });
  return sum;
}

/// To the grid and back, without forces.
void transfer(Domain& domain) {
  scatter(domain, ScatterPart::motion);
  grid_velocities(domain);
  FullMassMatrix matrix(domain.spec.scheme.fmpm_order);
  matrix.solve(domain);
  gather(domain, 1e-3, {.velocity = true});
  matrix.restore(domain);
}

TEST_P(FullMass, KeepsMomentum) {
  for (const int order : {2, 5, 10}) {
    Domain domain(GetParam().spec(order));
    shuffle(domain);
    const Vector before = momentum(domain);
    double scale = 0.0;
    for_particles(domain,
                  [&](Particles& p, std::size_t k) { scale += p.mass[k] * std::hypot(p.vx[k], p.vy[k]); });
    transfer(domain);
    const Vector after = momentum(domain);
    EXPECT_NEAR(after.x, before.x, 1e-14 * scale);
    EXPECT_NEAR(after.y, before.y, 1e-14 * scale);
  }
}

TEST_P(FullMass, LeavesATranslationAlone) {
  Domain domain(GetParam().spec(10));
  shuffle(domain);
  for_particles(domain, [](Particles& p, std::size_t k) {
    p.vx[k] = 3.0;
    p.vy[k] = -2.0;
  });
  transfer(domain);
  for_particles(domain, [](Particles& p, std::size_t k) {
    EXPECT_NEAR(p.vx[k], 3.0, 1e-11);
    EXPECT_NEAR(p.vy[k], -2.0, 1e-11);
  });
}

/// FMPM is the projection of particle velocities to those that the grid can give, in the limit: it can only
/// take energy, and the less the higher its order.
TEST_P(FullMass, TakesLessEnergyTheHigherItsOrder) {
  double before = 0.0;
  double kept = 0.0;
  for (const int order : {2, 3, 5, 10}) {
    Domain domain(GetParam().spec(order));
    shuffle(domain);
    before = test_support::kinetic_energy(domain);
    transfer(domain);
    const double after = test_support::kinetic_energy(domain);
    EXPECT_GT(after, kept);
    kept = after;
  }
  EXPECT_LT(kept, before);
}

INSTANTIATE_TEST_SUITE_P(Meshes, FullMass,
                         testing::Values(Mesh{"uniform", &fmpm_box}, Mesh{"periodic", &periodic_box},
                                         Mesh{"graded", &graded_box}),
                         [](const auto& mesh) { return mesh.param.name; });

/// act(n, x, y) for the nodes of a uniform grid.
template <typename Act>
void for_nodes(const Grid& grid, const Act& act) {
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i)
      act(grid.index(i, j), grid.x0 + i * grid.h, grid.y0 + j * grid.h);
}

/// What was v_p = A x_p is A x_p - S (I - F)^k A x_i after a transfer: exact inside, not at free edges, where
/// lumped masses stand beside those whose velocity they have.
TEST(FullMassOfLinearVelocities, IsExactInsideAndClosedFormAtEdges) {
  const int order = 3;
  for (const bool in_place : {true, false}) {
    Domain domain(fmpm_box(order));
    if (!in_place)
      shuffle(domain);
    const auto linear = [](double x, double y) { return 0.7 * x - 0.4 * y; };
    for_particles(domain, [&](Particles& p, std::size_t k) { p.vx[k] = linear(p.x[k], p.y[k]); });
    transfer(domain);
    NodeField of_nodes(domain.grid.size());
    for_nodes(domain.grid, [&](std::size_t n, double x, double y) { of_nodes[n] = linear(x, y); });
    const Dense dense(domain);
    Eigen::VectorXd rest = dense.of(of_nodes);
    for (int j = 0; j < order; ++j)
      rest -= dense.read_and_told(rest);
    rest = dense.s * rest;
    Eigen::Index next = 0;
    for_particles(domain, [&](Particles& p, std::size_t k) {
      const double exact = linear(p.x[k], p.y[k]);
      EXPECT_NEAR(p.vx[k], exact - rest[next++], 1e-12);
      const double cells_inside = std::min({p.x[k], 4.0 - p.x[k], -p.y[k], 3.0 + p.y[k]}) / 0.5;
      const bool inside = in_place && cells_inside > order;
      EXPECT_NEAR(p.vx[k], exact, inside ? 1e-12 : 0.03); // of 2.8 m/s; a cell apart 0.35 m/s
    });
  }
}

/// From v_p to S v(k) the angular momentum changes by that of -(I - F)^k v+.
TEST(FullMassAngularMomentum, LosesWhatTheIterationHasLeft) {
  const int order = 4;
  Domain domain(fmpm_box(order));
  shuffle(domain);
  const auto angular_momentum = [&] {
    double sum = 0.0;
    for_particles(domain, [&](Particles& p, std::size_t k) {
      sum += p.mass[k] * (p.x[k] * p.vy[k] - p.y[k] * p.vx[k]);
    });
    return sum;
  };
  const double before = angular_momentum();
  scatter(domain, ScatterPart::motion);
  grid_velocities(domain);
  const Dense dense(domain);
  Eigen::VectorXd left_x = dense.of(domain.grid.vx_new);
  Eigen::VectorXd left_y = dense.of(domain.grid.vy_new);
  for (int j = 0; j < order; ++j) {
    left_x -= dense.read_and_told(left_x);
    left_y -= dense.read_and_told(left_y);
  }
  NodeField x(domain.grid.size()), y(domain.grid.size());
  for_nodes(domain.grid, [&](std::size_t n, double at_x, double at_y) {
    x[n] = at_x;
    y[n] = at_y;
  });
  const double lost =
      dense.node_mass.dot(dense.of(x).cwiseProduct(left_y) - dense.of(y).cwiseProduct(left_x));
  transfer(domain);
  EXPECT_GT(std::abs(lost), 1.0); // kg m/s
  EXPECT_NEAR(angular_momentum(), before - lost, 1e-10 * std::abs(before));
}

/// Velocities that alternate between the particles of a cell bring nothing to any node. FLIP keeps them for
/// ever, FMPM for no step.
TEST(FullMassNullSpace, IsGoneAfterATransfer) {
  for (const auto kind : {Transfer::flip, Transfer::fmpm}) {
    Spec spec = periodic_box(5);
    spec.scheme.transfer = kind;
    Domain domain(spec);
    for_particles(domain, [](Particles& p, std::size_t k) {
      p.vx[k] = std::lround(p.x[k] / 0.25 - 0.5) % 2 == 0 ? 1.0 : -1.0;
    });
    const double before = test_support::kinetic_energy(domain);
    domain.faces.clear();
    Stepper stepper(domain, 0.0, test_support::no_traction());
    stepper.step();
    const double kept = test_support::kinetic_energy(domain) / before;
    EXPECT_NEAR(kept, kind == Transfer::flip ? 1.0 : 0.0, 1e-12);
  }
}

/// Two particles in place to a cell read and tell a wave of theta a cell with F = 5/8 + 3/8 cos(theta): a
/// transfer leaves 1 - (1 - F)^k of it on the grid, a loss of order theta^2k.
TEST(FullMassDamping, OfAWaveIsThatOfTheClosedForm) {
  const double width = 16.0;
  for (const int order : {2, 3, 4}) {
    double coarse_loss = 0.0;
    for (const int waves : {2, 1}) {
      Spec spec = test_support::elastic_box(width, 2.0, 0.5);
      spec.sides = mpm_domain::Sides::periodic;
      spec.scheme = {.transfer = Transfer::fmpm, .fmpm_order = order};
      Domain domain(spec);
      const double number = 2.0 * std::numbers::pi * waves / width; // 1/m
      for_particles(domain, [&](Particles& p, std::size_t k) { p.vy[k] = std::cos(number * p.x[k]); });
      const auto amplitude = [&] {
        scatter(domain, ScatterPart::motion);
        grid_velocities(domain);
        return domain.grid.vy[domain.grid.index(domain.grid.first_column, domain.grid.ny / 2)];
      };
      const double before = amplitude();
      transfer(domain);
      const double loss = 1.0 - amplitude() / before;
      const double theta = number * 0.5;
      const double f = 0.625 + 0.375 * std::cos(theta);
      EXPECT_NEAR(loss, std::pow(1.0 - f, order), 1e-13) << order << " " << waves;
      if (waves == 2)
        coarse_loss = loss;
      else
        EXPECT_NEAR(std::log2(coarse_loss / loss), 2.0 * order, 0.2) << order;
    }
  }
}

TEST(FullMassScheme, RefusesOrdersOutOfRangeAndUsl) {
  for (const int order : {1, 11})
    EXPECT_THROW(Domain{fmpm_box(order)}, std::invalid_argument);
  Spec usl = fmpm_box(2);
  usl.scheme.order = StepOrder::usl;
  EXPECT_THROW(Domain{usl}, std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
