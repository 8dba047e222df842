#pragma once

// Boundary faces ride on the particles that lay along the left, right and lower edge of the model. A face
// covers its particle's side, length 2l. Its weights are the grid's hat functions averaged along the face,
//
//     W_i = 1/(2l) int_face N_i ds,
//
// so that tractions t spread as f_i = sum_f 2l W_if t_f balance a uniform stress exactly, wherever the
// particle lies in its cell, and a dashpot can only take energy out: the velocity it reads, v^m_f = sum_i
// W_if v_i, uses the same W.

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/grid/grid.hpp"
#include "mpm_domain/particles/particles.hpp"
#include "mpm_domain/tiles/worker_pool.hpp"
#include "mpm_domain/transfer/kernel.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Domain;

/// A face: the particle it rides on and what Eq. (6) needs to know.
struct BoundaryFace {
  Side side = Side::left;
  std::size_t set = 0;  ///< which soil's particles
  std::uint32_t id = 0; ///< the particle
  Vector position;      ///< where it lay at the start: the material point its free field is taken from, m
  double length = 0.0;  ///< m
  eq6::Face face;       ///< normal and impedances; these are zero before a matched layer
  double mass = 0.0;    ///< of a matched layer's nodes that move with the face, kg/m2
  int level = unknown;  ///< of the one lattice of a graded mesh that it can touch until the next sort

  static constexpr int unknown = -1; ///< or several
};

/// A node that a face touches, and W.
struct FaceWeight {
  std::size_t node = 0;
  double w = 0.0;
};

using FaceWeights = std::vector<FaceWeight>;

/// Diagonal of the dashpots rho c_p n n^T + rho c_s t t^T of a face, whose normal lies along an axis, Pa s/m.
inline Vector dashpots(const BoundaryFace& face) {
  const auto& [n, p, s] = face.face;
  return {p * n.x * n.x + s * n.y * n.y, p * n.y * n.y + s * n.x * n.x};
}

/// The faces of the model's left, right and lower edge, in this order, each from low to high coordinate.
/// Their impedances are those of the soil in its present stress, at the base those of the ground below, where
/// the spec gives it.
std::vector<BoundaryFace> find_faces(std::vector<Particles>& sets, const Spec& spec);

/// act(f) for all faces, portions of them side by side.
template <typename Act>
void for_faces(WorkerPool& workers, std::size_t count, const Act& act) {
  constexpr std::size_t portion = 64;
  workers.run((count + portion - 1) / portion, [&](std::size_t task) {
    for (std::size_t f = task * portion; f < std::min((task + 1) * portion, count); ++f)
      act(f);
  });
}

/// Finds the levels of faces whose way until the next sort keeps them on one lattice.
void find_levels(Domain& domain);

/// Weights of a face at its particle's present place.
void face_weights(const Domain& domain, const BoundaryFace& face, FaceWeights& weights);
/// Those of all faces.
void face_weights(Domain& domain, std::span<FaceWeights> weights);

/// Books the work of a face's traction (Pa) over a time (s) at the velocity v (m/s): `own` of it, of the
/// soil's velocity on dashpots and matched layers, as theirs, what held the model at rest as static, and the
/// rest as input.
void book_face_work(Domain& domain, std::size_t face, double dt, Vector own, Vector traction, Vector v);

} // namespace tremolo::mpm_domain
