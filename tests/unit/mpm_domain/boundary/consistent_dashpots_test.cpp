// The dashpots' implicit half step against a dense solution of the same equations, whose forces the test puts
// together by itself.

#include "mpm_domain/boundary/consistent_dashpots.hpp"

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/lumped_faces.hpp"
#include "tests/support/quiet_ground.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// Varies smoothly along the faces, Pa.
Vector traction_on(const BoundaryFace& face) {
  return {std::cos(0.4 * face.position.x), std::sin(0.4 * face.position.y)};
}

/// A box of 6 m by 4 m at rest.
struct Box {
  Box()
      : domain(test_support::elastic_box(6.0, 4.0, 1.0)), all(domain.boundary.faces().size()),
        weights(all.size()) {
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (std::size_t f = 0; f < weights.size(); ++f)
      face_weights(domain, domain.boundary.faces()[f], weights[f]);
    nodes.restart(domain.grid.size());
    nodes.add(weights);
    scatter(domain, ScatterPart::both);
    grid_velocities(domain, domain.soil_rows);
  }

  Domain domain;
  std::vector<std::size_t> all; ///< faces
  std::vector<FaceWeights> weights;
  FaceNodes nodes;
};

/// Its nodes carry the tractions of the faces, and their dashpots lumped.
struct LoadedBox : Box {
  LoadedBox() { test_support::add_lumped_faces(domain, traction_on); }
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
    const BoundaryFace& face = box.domain.boundary.faces()[f];
    for (const auto& [i, w_i] : box.weights[f])
      for (const auto& [j, w_j] : box.weights[f])
        matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
            0.5 * dt * face.length * dashpot_diagonal(face).x * w_i * w_j;
  }
  return matrix.partialPivLu().solve(force);
}

/// Largest difference of the update's accelerations in x from the exact ones, over the largest of those.
double error(LoadedBox& box, const Eigen::VectorXd& exact, double dt) {
  update_grid(box.domain, dt, box.domain.soil_rows);
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
  ConsistentDashpots dashpots(box.nodes);
  dashpots.fit(box.domain.grid.size());
  dashpots.correct(box.domain, box.domain.boundary.faces(), box.all, box.weights, dt);
  EXPECT_GT(lumped, 0.01);
  EXPECT_LT(error(box, exact, dt), 0.02 * lumped);
}

/// The boundary's own pass does all of it.
TEST(ConsistentDashpots, AreThoseOfTheBoundary) {
  LoadedBox loaded;
  Box box;
  Domain& domain = box.domain;
  const double dt = 0.5 * critical_time_step(domain, 0.0);
  ConsistentDashpots dashpots(loaded.nodes);
  dashpots.fit(loaded.domain.grid.size());
  dashpots.correct(loaded.domain, loaded.domain.boundary.faces(), loaded.all, loaded.weights, dt);
  Step step(domain, domain.energy, 0.0);
  step.ticks.set_step(dt, dt);
  for (BoundaryFace& face : domain.boundary.faces())
    face.held = traction_on(face);
  domain.boundary.read_soil(domain);
  domain.boundary.exchange(step, test_support::quiet_ground());
  domain.boundary.apply(step);
  double largest = 0.0;
  for (Domain* d : {&domain, &loaded.domain})
    update_grid(*d, dt, d->soil_rows);
  for (const double a : domain.grid.ay)
    largest = std::max(largest, std::abs(a));
  EXPECT_GT(largest, 0.0);
  for (std::size_t n = 0; n < domain.grid.size(); ++n) {
    EXPECT_NEAR(domain.grid.ax[n], loaded.domain.grid.ax[n], 1e-12 * largest);
    EXPECT_NEAR(domain.grid.ay[n], loaded.domain.grid.ay[n], 1e-12 * largest);
  }
}

TEST(ConsistentDashpots, AddNoMomentum) {
  LoadedBox box;
  ConsistentDashpots dashpots(box.nodes);
  dashpots.fit(box.domain.grid.size());
  dashpots.correct(box.domain, box.domain.boundary.faces(), box.all, box.weights, 1e-3);
  double scale = 0.0;
  for (const double c : box.domain.grid.dashpot_x)
    scale += c;
  Vector force;
  for (const std::size_t n : box.nodes.all())
    force += dashpots.force_on(n);
  EXPECT_NEAR(force.x, 0.0, 1e-14 * scale);
  EXPECT_NEAR(force.y, 0.0, 1e-14 * scale);
}

} // namespace
} // namespace tremolo::mpm_domain
