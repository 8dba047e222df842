#include "mpm_domain/gravity/static_traction.hpp"

#include "mpm_domain/fields/zero_pages.hpp"
#include "mpm_domain/ranks/lists_of_all.hpp"

#include <Eigen/Sparse>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
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

/// The soil's own traction sigma n at a face, and what it spreads over.
struct FaceAtRest {
  Vector traction; ///< Pa
  FaceWeights weights;
};

Vector soil_traction(const Particles& set, const BoundaryFace& face) {
  const std::size_t k = set.index_of[face.id];
  const Vector n = face.ground.normal;
  return {set.sxx[k] * n.x + set.sxy[k] * n.y, set.sxy[k] * n.x + set.syy[k] * n.y};
}

void put(std::size_t f, const FaceAtRest& face, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {static_cast<double>(f), face.traction.x, face.traction.y,
                                 static_cast<double>(face.weights.size())});
  for (const auto& [node, w] : face.weights)
    numbers.insert(numbers.end(), {static_cast<double>(node), w});
}

void take(const std::vector<double>& numbers, std::vector<FaceAtRest>& faces) {
  for (auto next = numbers.begin(); next != numbers.end();) {
    FaceAtRest& face = faces[static_cast<std::size_t>(*next++)];
    face.traction.x = *next++;
    face.traction.y = *next++;
    face.weights.resize(static_cast<std::size_t>(*next++));
    for (auto& [node, w] : face.weights) {
      node = static_cast<std::size_t>(*next++);
      w = *next++;
    }
  }
}

/// Finds the state of all faces: each rank works out those of its own particles, and all take them.
std::vector<FaceAtRest> faces_at_rest(const Domain& domain) {
  const std::span<const BoundaryFace> faces = domain.boundary.faces();
  std::vector<FaceAtRest> at_rest(faces.size());
  std::vector<double> own;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Particles& set = domain.sets[faces[f].set];
    if (domain.share && set.index_of[faces[f].id] == Particles::nowhere)
      continue;
    at_rest[f].traction = soil_traction(set, faces[f]);
    face_weights(domain, faces[f], at_rest[f].weights);
    if (domain.share)
      put(f, at_rest[f], own);
  }
  if (domain.share)
    take(lists_of_all(*domain.share->ranks, own), at_rest);
  return at_rest;
}

/// Solves for one direction and returns the largest unbalanced force.
/// @param nodes      that are held in it, of those of the reactions the first
/// @param reactions  N/m
double solve(Domain& domain, const std::vector<FaceAtRest>& at_rest, std::span<const std::size_t> nodes,
             std::span<const Vector> reactions, Direction d) {
  ZeroPages<Eigen::Index> row_after(domain.grid.size()); // by node: 1 + its row, 0 if it has none
  for (std::size_t i = 0; i < nodes.size(); ++i)
    row_after[nodes[i]] = static_cast<Eigen::Index>(i + 1);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t f = 0; f < at_rest.size(); ++f) {
    const BoundaryFace& face = domain.boundary.faces()[f];
    if (!holds(face, d))
      continue;
    for (const FaceWeight& weight : at_rest[f].weights)
      if (row_after[weight.node] > 0 && weight.w != 0.0)
        entries.emplace_back(row_after[weight.node] - 1, static_cast<Eigen::Index>(f),
                             face.length * weight.w);
  }
  Eigen::SparseMatrix<double> a(static_cast<Eigen::Index>(nodes.size()),
                                static_cast<Eigen::Index>(domain.boundary.faces().size()));
  a.setFromTriplets(entries.begin(), entries.end());

  Eigen::VectorXd t = Eigen::VectorXd::Zero(a.cols());
  for (std::size_t f = 0; f < domain.boundary.faces().size(); ++f)
    if (holds(domain.boundary.faces()[f], d))
      t[static_cast<Eigen::Index>(f)] = component(at_rest[f].traction, d);
  Eigen::VectorXd r(a.rows());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    r[static_cast<Eigen::Index>(i)] = component(reactions[i], d);

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
  for (const Vector& force : reactions.force)
    largest = std::max({largest, std::abs(force.x), std::abs(force.y)});
  const std::vector<FaceAtRest> at_rest = faces_at_rest(domain);
  const double left = std::max(solve(domain, at_rest, held_x, reactions.force, Direction::x),
                               solve(domain, at_rest, reactions.base, reactions.force, Direction::y));
  const double relative = left / largest;
  if (!(relative < 1e-9))
    throw std::runtime_error(fmt::format(
        "the boundary faces hold the reactions of the gravity stage only to {:.3g}; wanted 1e-9", relative));
  return relative;
}

} // namespace tremolo::mpm_domain
