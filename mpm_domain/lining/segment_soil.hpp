#pragma once

// The soil's side of the segments, B m^-1 B^T and what impulses change, node after node: a node belongs to
// few segments, and only segments that share nodes answer to each other. So the matrix has few blocks beside
// those of its diagonal, and with segments numbered from both sides of the first, a narrow band
// (beam/band_matrix.hpp).

#include "mpm_domain/lining/segment_rows.hpp"
#include "mpm_domain/lining/soil_motion.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Velocity change of a node due to impulses, m/s.
struct NodeChange {
  std::size_t node;
  Vector change; ///< of the grains
  Vector water;  ///< of water that flows; elsewhere as of the grains
};

class SegmentSoil {
public:
  SegmentSoil() = default;
  SegmentSoil(std::span<const SegmentRows> rows, const SoilMotion& soil);

  /// Adds B m^-1 B^T to a matrix stored by rows, in the order N, T of each segment.
  void add_answer(std::span<double> to) const;
  /// Velocity changes of the soil's nodes, in their order, due to impulses on the lining, one per segment
  /// (kg/s).
  std::vector<NodeChange> changes(std::span<const Vector> impulses, const SoilMotion& soil) const;
  /// The impulses that end the closing speeds of some rows, none at the others, where the lining does not
  /// answer: by row, kg/s.
  /// @param stopped  whether a row is one of them
  std::vector<double> stop(std::span<const double> closing, const std::vector<bool>& stopped) const;

private:
  struct Member {
    std::size_t node;
    std::size_t row; ///< of the segment
    double share;
  };
  /// Coupling block of two segments.
  struct Block {
    std::size_t a, b;             ///< b <= a
    std::array<double, 4> answer; ///< N and T of a to N of b, to T of b
  };

  void take_members(std::span<const SegmentRows> rows);

  std::size_t rows_ = 0;
  std::vector<Member> members_; ///< node after node
  std::vector<Block> blocks_;
};

} // namespace tremolo::mpm_domain
