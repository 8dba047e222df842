#pragma once

// Weights of the soil's nodes and of the beam in the motion of a segment of a lining's surface. With N_I the
// bilinear hat of node I at the points X_q of the segment, and a part c_I of it that counts,
//
//     B w = mean_q sum_I c_I N_I(X_q) w_I / sum_I c_I N_I(X_q),       H v = mean_q (H v)(X'_q),
//
//     X'_q = sum c_I N_I x_I / sum c_I N_I,       c_I = min(1, 100 m_I/(rho h^2)),
//
// X'_q being the position at which the soil answers. Where all four nodes of a cell have soil that is X_q.
// Nodes count by their mass while soil barely reaches them: B m^-1 B^T then goes to zero with m_I. With c_I =
// 1 a node that the smallest motion of soil has given next to no mass would answer for its segment, which
// would lose its pressure at once. Both sides act at the same position, so that the impulses B^T j on the
// soil and H^T j on the beam have the same sum and the same moment: momentum and angular momentum are exact.
//
// Contact at each node by itself would tie soil to the lining at up to a cell from it, and so make the lining
// larger than it is; the means over a cell do not.

#include "mpm_domain/kernel/node_share.hpp"
#include "mpm_domain/lining/surface.hpp"
#include "mpm_domain/spec/lattice.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct SegmentRows {
  std::size_t segment = 0;     ///< its number on the surface
  std::vector<NodeShare> soil; ///< B
  std::vector<BeamShare> beam; ///< H
  Vector normal;               ///< from soil to lining
  Vector position;             ///< of the impulse, m

  Vector tangent() const { return {-normal.y, normal.x}; }
};

/// The rows of the segments that have soil before them, in their order.
/// @param mass   of the nodes, kg/m
/// @param full   mass of a node that soil fills, rho h^2, kg/m
std::vector<SegmentRows> find_rows(const LiningSurface& surface, const Beam& beam, const Lattice& lattice,
                                   std::span<const double> mass, double full);

/// B w.
Vector soil_velocity(const SegmentRows& rows, std::span<const double> wx, std::span<const double> wy);
/// H v.
Vector beam_velocity(const SegmentRows& rows, std::span<const double> v);

} // namespace tremolo::mpm_domain
