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
#include "mpm_domain/particles/particles.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

class Communicator;
struct Ground;

/// "left side", "right side", "base"
std::string text_of(Side side);

/// Changes that supports (support.hpp) have made to a face.
struct Behind {
  bool has_dashpots = true;   ///< of Eq. (6); elsewhere a support stands in their place
  bool is_tied = false;       ///< to the opposite side: no free field drives it
  bool has_own_field = false; ///< beside the one that Eq. (6) takes
  Vector moving_mass;         ///< of what stands there and moves with the face, by direction, kg/m2
};

/// A face: the particle it rides on, and what Eq. (6) needs to know.
struct BoundaryFace {
  Side side = Side::left;
  std::size_t set = 0;  ///< which soil's particles
  std::uint32_t id = 0; ///< the particle
  Vector position;      ///< where it lay at the start: the material point its free field is taken from, m
  double start_x = 0.0; ///< of the particle at the start, m
  double length = 0.0;  ///< m; of a side where there is pore water, at present
  eq6::Face ground; ///< normal, and the impedances of the soil in its stress at rest, or of the ground below
                    ///< the base
  double density = 0.0; ///< of that soil with the water in it, or of that ground, kg/m3
  Vector held;          ///< f^st of Eq. (6), what held the model at rest, Pa
  Behind behind;
  int level = unknown; ///< of the one lattice of a graded mesh that it can touch until the next sort

  static constexpr int unknown = -1; ///< or several

  /// The face with the dashpots of Eq. (6), or without any if a support replaces them.
  eq6::Face dashpots() const { return behind.has_dashpots ? ground : eq6::Face{ground.normal, 0.0, 0.0}; }
};

/// A node that a face touches, and W.
struct FaceWeight {
  std::size_t node = 0;
  double w = 0.0;
};

using FaceWeights = std::vector<FaceWeight>;

/// A value along the normal, which lies along an axis, and one across it, by the directions of the axes.
inline Vector by_direction(const Vector& normal, double along, double across) {
  return normal.x != 0.0 ? Vector{along, across} : Vector{across, along};
}

/// Diagonal of the dashpots rho c_p n n^T + rho c_s t t^T of a face, whose normal lies along an axis, Pa s/m.
inline Vector dashpot_diagonal(const BoundaryFace& face) {
  const auto& [n, p, s] = face.dashpots();
  return {p * n.x * n.x + s * n.y * n.y, p * n.y * n.y + s * n.x * n.x};
}

/// The faces of the model's left, right and lower edge, in this order, each from low to high coordinate.
/// Their impedances are those of the soil in its present stress, at the base those of the ground below, where
/// the spec gives it.
/// @param ranks  each of which has some of the particles, and gets the faces of all; null: there is one
/// process
std::vector<BoundaryFace> find_faces(std::vector<Particles>& sets, const Spec& spec,
                                     Communicator* ranks = nullptr);

/// The level of a face whose way until the next sort keeps it on one lattice; otherwise unknown.
int level_of(const Ground& ground, const BoundaryFace& face);

/// Position of a face's particle, and half the sides of its box, m.
struct FacePosition {
  Vector centre;
  Vector half;
};
FacePosition position_of(const BoundaryFace& face, const Particles& set);

/// The soil at a face: its particle.
struct FaceSoil {
  FacePosition position;
  double moved = 0.0;  ///< along x, m
  double syy = 0.0;    ///< total where there is pore water and over that of the water at rest, Pa
  double excess = 0.0; ///< pore pressure over that of the water at rest, Pa
  double length = 0.0; ///< of the face: a side is as high as its soil, which settles, V/2l; m
  Vector displacement; ///< of the particle since the start, m
};
FaceSoil soil_at(const BoundaryFace& face, const Particles& set);

/// The side of its particle's box that a face covers: a line.
mesh::Rectangle line_of(const BoundaryFace& face, const FacePosition& position);

/// Limits on the positions of soil: at a side with faces, overflow_cells (particles/grid_growth.hpp) beyond
/// the outermost face.
Box soil_limits(const Ground& ground, std::span<const BoundaryFace> faces);

/// Weights of a face with its particle at a point, or at its present one, of nodes that are not tied.
void face_weights(const Ground& ground, const BoundaryFace& face, const FacePosition& position,
                  FaceWeights& weights);
void face_weights(const Ground& ground, const BoundaryFace& face, FaceWeights& weights);

} // namespace tremolo::mpm_domain
