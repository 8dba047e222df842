// The dashpots' implicit half step against a dense solution of the same equations.

#include "mpm_domain/boundary/consistent_dashpots.hpp"

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// A box of 6 m by 4 m whose faces carry tractions that vary smoothly along them.
struct LoadedBox {
  LoadedBox() : domain(test_support::elastic_box(6.0, 4.0, 1.0)), weights(domain.faces.size()) {
    for (std::size_t f = 0; f < weights.size(); ++f)
      face_weights(domain, domain.faces[f], weights[f]);
    scatter(domain, ScatterPart::both);
    grid_velocities(domain);
    std::vector<Vector> tractions;
    for (const BoundaryFace& face : domain.faces)
      tractions.push_back({std::cos(0.4 * face.position.x), std::sin(0.4 * face.position.y)});
    spread_tractions(domain, weights, tractions);
  }

  Domain domain;
  std::vector<FaceWeights> weights;
};

/// Accelerations in x by (M + dt/2 sum_f L Z W W^T) a = f.
Eigen::VectorXd exact_accelerations(const LoadedBox& box, double dt) {
  const Grid& grid = box.domain.grid;
  const auto size = static_cast<Eigen::Index>(grid.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(size);
  for (Eigen::Index n = 0; n < size; ++n)
    if (const double mass = grid.mass[static_cast<std::size_t>(n)]; mass > empty_mass(box.domain)) {
      matrix(n, n) = mass;
      force(n) = grid.force_x[static_cast<std::size_t>(n)];
    }
  for (std::size_t f = 0; f < box.weights.size(); ++f) {
    const BoundaryFace& face = box.domain.faces[f];
    for (const auto& [i, w_i] : box.weights[f])
      for (const auto& [j, w_j] : box.weights[f])
        matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
            0.5 * dt * face.length * dashpots(face).x * w_i * w_j;
  }
  return matrix.partialPivLu().solve(force);
}

/// Largest difference of the update's accelerations in x from the exact ones, over the largest of those.
double error(LoadedBox& box, const Eigen::VectorXd& exact, double dt) {
  update_grid(box.domain, dt);
  double largest = 0.0;
  for (Eigen::Index n = 0; n < exact.size(); ++n)
    largest = std::max(largest, std::abs(box.domain.grid.ax[static_cast<std::size_t>(n)] - exact(n)));
  return largest / exact.lpNorm<Eigen::Infinity>();
}

TEST(ConsistentDashpots, SolveWithTheFacesOwnWeights) {
  LoadedBox box;
  const double dt = 0.5 * critical_time_step(box.domain, 0.0);
  const Eigen::VectorXd exact = exact_accelerations(box, dt);
  const double lumped = error(box, exact, dt);
  ConsistentDashpots dashpots;
  dashpots.correct(box.domain, box.weights, dt);
  EXPECT_GT(lumped, 0.01);
  EXPECT_LT(error(box, exact, dt), 0.02 * lumped);
}

TEST(ConsistentDashpots, AddNoMomentum) {
  LoadedBox box;
  ConsistentDashpots dashpots;
  dashpots.correct(box.domain, box.weights, 1e-3);
  const NodeField uniform(box.domain.grid.size(), 1.0);
  const NodeField none(box.domain.grid.size(), 0.0);
  double scale = 0.0;
  for (const double c : box.domain.grid.dashpot_x)
    scale += c;
  EXPECT_NEAR(dashpots.power(uniform, none), 0.0, 1e-14 * scale);
  EXPECT_NEAR(dashpots.power(none, uniform), 0.0, 1e-14 * scale);
}

} // namespace
} // namespace tremolo::mpm_domain
