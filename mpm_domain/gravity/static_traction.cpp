#include "mpm_domain/gravity/static_traction.hpp"

#include <Eigen/Sparse>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

enum class Direction { x, y };

double component(const Vector& v, Direction d) {
  return d == Direction::x ? v.x : v.y;
}

/// Faces that hold in a direction: the base in both, sides across only (they were free to settle).
bool holds(const BoundaryFace& face, Direction d) {
  return face.side == Side::base || d == Direction::x;
}

/// The soil's own traction sigma n at a face.
Vector soil_traction(const Particles& set, const BoundaryFace& face) {
  const std::size_t k = set.index_of[face.id];
  const Vector n = face.ground.normal;
  return {set.sxx[k] * n.x + set.sxy[k] * n.y, set.sxy[k] * n.x + set.syy[k] * n.y};
}

/// Solves for one direction and returns the largest unbalanced force.
double solve(Domain& domain, const std::vector<std::size_t>& nodes, const Reactions& reactions, Direction d) {
  std::vector<Eigen::Index> row(domain.grid.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    row[nodes[i]] = static_cast<Eigen::Index>(i);
  std::vector<Eigen::Triplet<double>> entries;
  FaceWeights weights;
  for (std::size_t f = 0; f < domain.boundary.faces().size(); ++f) {
    const BoundaryFace& face = domain.boundary.faces()[f];
    if (!holds(face, d))
      continue;
    face_weights(domain, face, weights);
    for (const FaceWeight& weight : weights)
      if (row[weight.node] >= 0 && weight.w != 0.0)
        entries.emplace_back(row[weight.node], static_cast<Eigen::Index>(f), face.length * weight.w);
  }
  Eigen::SparseMatrix<double> a(static_cast<Eigen::Index>(nodes.size()),
                                static_cast<Eigen::Index>(domain.boundary.faces().size()));
  a.setFromTriplets(entries.begin(), entries.end());

  Eigen::VectorXd t = Eigen::VectorXd::Zero(a.cols());
  for (std::size_t f = 0; f < domain.boundary.faces().size(); ++f)
    if (holds(domain.boundary.faces()[f], d))
      t[static_cast<Eigen::Index>(f)] = component(
          soil_traction(domain.sets[domain.boundary.faces()[f].set], domain.boundary.faces()[f]), d);
  Eigen::VectorXd r(a.rows());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    r[static_cast<Eigen::Index>(i)] = component(reactions.force[nodes[i]], d);

  // Least-norm correction A^T (A A^T)^-1 (r - A t), refined once for the last digits.
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> normal(a * a.transpose());
  if (normal.info() != Eigen::Success)
    throw std::runtime_error(
        "the boundary faces cannot carry the reactions of the gravity stage: singular system");
  for (int pass = 0; pass < 2; ++pass)
    t += a.transpose() * normal.solve(r - a * t);
  for (std::size_t f = 0; f < domain.boundary.faces().size(); ++f)
    if (Vector& held = domain.boundary.faces()[f].held; d == Direction::x)
      held.x = t[static_cast<Eigen::Index>(f)];
    else
      held.y = t[static_cast<Eigen::Index>(f)];
  return (r - a * t).lpNorm<Eigen::Infinity>();
}

} // namespace

double replace_constraints(Domain& domain, const Reactions& reactions) {
  if (domain.spec.rigid_base)
    return 0.0;
  std::vector<std::size_t> held_x = reactions.base;
  held_x.insert(held_x.end(), reactions.sides.begin(), reactions.sides.end());
  double largest = 0.0;
  for (const std::size_t n : held_x)
    largest = std::max({largest, std::abs(reactions.force[n].x), std::abs(reactions.force[n].y)});
  const double left = std::max(solve(domain, held_x, reactions, Direction::x),
                               solve(domain, reactions.base, reactions, Direction::y));
  const double relative = left / largest;
  if (!(relative < 1e-9))
    throw std::runtime_error(fmt::format(
        "the boundary faces hold the reactions of the gravity stage only to {:.3g}; wanted 1e-9", relative));
  return relative;
}

} // namespace tremolo::mpm_domain
