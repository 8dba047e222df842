#pragma once

// Rings of beam elements, and their modes by dense matrices.

#include "mpm_domain/lining/beam/beam_step.hpp"

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace tremolo::test_support {

/// A ring of concrete: 0.3 m thick, its axis 3 m from the centre.
inline constexpr double ring_radius = 3.0;
inline constexpr double ring_thickness = 0.3;
inline constexpr mpm_domain::BeamSection ring_section =
    mpm_domain::plate_section(ring_thickness, 30e9, 0.2, 2500.0);

/// The section without shear and rotary mass, as Euler and Bernoulli have it.
inline mpm_domain::BeamSection euler_bernoulli(mpm_domain::BeamSection section) {
  section.shear = std::numeric_limits<double>::infinity();
  section.rotary *= 1e-6; // none at all would leave a hinge without inertia
  return section;
}

/// A regular polygon with the area of a circle, its first node on the x-axis, about the origin.
inline mpm_domain::BeamShape ring_shape(std::size_t nodes, std::vector<std::size_t> hinges = {}) {
  const double angle = 2.0 * std::numbers::pi / static_cast<double>(nodes);
  const double reach = ring_radius * std::sqrt(angle / std::sin(angle));
  mpm_domain::BeamShape shape{.nodes = {}, .closed = true, .hinges = std::move(hinges)};
  for (std::size_t k = 0; k < nodes; ++k) {
    const double at = angle * static_cast<double>(k);
    shape.nodes.push_back({reach * std::cos(at), reach * std::sin(at)});
  }
  return shape;
}

/// A straight beam from the origin along x.
inline mpm_domain::BeamShape bar_shape(double length, std::size_t elements) {
  mpm_domain::BeamShape shape{.nodes = {}, .closed = false, .hinges = {}};
  for (std::size_t k = 0; k <= elements; ++k)
    shape.nodes.push_back({length * static_cast<double>(k) / static_cast<double>(elements), 0.0});
  return shape;
}

/// df/dq at the present place by central differences.
inline Eigen::MatrixXd tangent(const mpm_domain::Beam& beam) {
  const std::size_t n = beam.positions().size();
  Eigen::MatrixXd k(n, n);
  const double step = 1e-6;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<double> forces[2];
    for (const int side : {0, 1}) {
      mpm_domain::Beam moved = beam;
      std::vector<double> v(n, 0.0);
      v[j] = side == 0 ? -step : step;
      moved.set_velocities(v);
      moved.move(1.0);
      forces[side] = moved.internal_forces();
    }
    for (std::size_t i = 0; i < n; ++i)
      k(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          (forces[1][i] - forces[0][i]) / (2.0 * step);
  }
  return k;
}

/// Natural frequencies of a free beam, from the lowest up, those of rigid motion and mechanisms as zero, Hz.
inline std::vector<double> frequencies(const mpm_domain::Beam& beam) {
  const Eigen::MatrixXd k = tangent(beam);
  const Eigen::VectorXd m = Eigen::Map<const Eigen::VectorXd>(beam.masses().data(), k.rows());
  const Eigen::VectorXd scale = m.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd symmetric = scale.asDiagonal() * (0.5 * (k + k.transpose())) * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(symmetric, Eigen::EigenvaluesOnly);
  std::vector<double> found;
  for (const double squared : modes.eigenvalues())
    found.push_back(squared < 1.0 ? 0.0 : std::sqrt(squared) / (2.0 * std::numbers::pi));
  return found;
}

/// Momentum along x and y and angular momentum about the origin.
inline std::array<double, 3> momenta(const mpm_domain::Beam& beam) {
  std::array<double, 3> sums{};
  for (std::size_t k = 0; k < beam.node_count(); ++k) {
    const std::size_t x = beam.first_dof(k);
    const double m = beam.masses()[x];
    const Vector p{m * beam.velocity(k).x, m * beam.velocity(k).y};
    sums[0] += p.x;
    sums[1] += p.y;
    sums[2] += cross(beam.position(k), p);
  }
  // All other degrees of freedom are rotations, of which a hinge has two.
  std::vector<bool> is_turn(beam.positions().size(), true);
  for (std::size_t k = 0; k < beam.node_count(); ++k)
    is_turn[beam.first_dof(k)] = is_turn[beam.first_dof(k) + 1] = false;
  for (std::size_t i = 0; i < is_turn.size(); ++i)
    if (is_turn[i])
      sums[2] += beam.masses()[i] * beam.velocities()[i];
  return sums;
}

/// Lets a beam come to rest under forces: steps so long that backward Euler damps all that moves.
inline void rest_under(mpm_domain::Beam& beam, const std::vector<double>& forces, int steps, double dt) {
  for (int k = 0; k < steps; ++k) {
    const mpm_domain::BeamStep step(beam, dt, dt, forces, 0.0);
    beam.set_velocities(step.trial());
    beam.move(dt);
  }
}

} // namespace tremolo::test_support
