#pragma once

// The part of the normal impulses at the segments that pore water carries, which causes no friction. Water of
// density rho_f that filled the soil's volume alone, m~_f = rho_f V at a node, and that met the lining as the
// soil does, would need the impulses q = p L dt,
//
//     (B_n m~_f^-1 B_n^T) q = B_n v_f* - H_n v+,         v+ = v* + A^-1 H^T j,
//
// with v_f* its velocity under its own pressure, without drag. This is the m~_f (v_f* - J U) of the nodes of
// rigid bodies (contact/impulses/rigid_contact.hpp) with the means of segments in the place of nodes. Where
// no stress passes between grains, soil and water press alike on every segment, however unevenly on two
// segments side by side, and N' = N - q vanishes at each.

#include "mpm_domain/lining/segment_rows.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// A node with water in its soil.
struct WetNode {
  std::size_t node;
  double mass;     ///< m~_f, kg/m
  Vector velocity; ///< v_f*, m/s
};

/// q = alone - answer j, by segment.
struct SegmentWater {
  std::vector<bool> wet;      ///< whether there is water
  std::vector<double> alone;  ///< kg/s
  std::vector<double> answer; ///< row after row, in the order N, T of each segment

  bool any() const { return !answer.empty(); }
};

/// @param nodes        in their order; others are dry
/// @param beam_answer  H A^-1 H^T, row after row
/// @param v            v*, m/s
SegmentWater find_segment_water(std::span<const SegmentRows> rows, std::span<const WetNode> nodes,
                                std::span<const double> beam_answer, std::span<const double> v);

} // namespace tremolo::mpm_domain
