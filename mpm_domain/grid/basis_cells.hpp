#pragma once

// The cells on which the basis is bilinear, leaves that are not split and quarters, in terms of real nodes.
// With the hat functions N_c of a cell's corners and the share R_ic of real node i in corner c (one, or a row
// of the prolongation),
//
//     N_i = sum_c R_ic N_c,    N_c = {(1 - xi)(1 - eta), xi (1 - eta), (1 - xi) eta, xi eta}.
//
// The part of a box that lies in a cell adds its share of the box times N_i at its centroid to S_i, and the
// same of grad N_i to G_i (box_average.hpp).

#include "mpm_domain/grid/graded_mesh.hpp"
#include "mpm_domain/kernel/lanes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace tremolo::mpm_domain {

/// Four real nodes of a cell's basis, a lane each. An unused lane has no share in any corner.
struct FourNodes {
  std::array<std::uint32_t, 4> node{};
  Lanes x{}, y{};                 ///< where they, or the images that belong to the cell, lie, m
  std::array<Lanes, 4> corners{}; ///< [corner] R
};

/// A cell; its nodes are the fours [first, end) of the table.
struct BasisCell {
  std::uint64_t key; ///< orders cells by their position in the mesh, not by the time of their request
  mesh::Rectangle all;
  double per_h = 0.0; ///< 1/m
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

/// A part of a box in a cell: its share of the box, and its centroid in the cell's coordinates.
struct BoxPart {
  double share;
  double xi;
  double eta;
};

/// A table of the requested cells.
class BasisCells {
public:
  /// Number of a cell in the table. A cell that is new is added.
  /// @param mesh  must be the same in every call
  std::uint32_t number_of(const GradedMesh& mesh, const mesh::Cell& cell);

  const BasisCell& operator[](std::uint32_t number) const { return cells_[number]; }
  const FourNodes& four(std::uint32_t position) const { return fours_[position]; }

private:
  void add_nodes(const GradedMesh& mesh, const mesh::Cell& cell);

  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::vector<BasisCell> cells_;
  std::vector<FourNodes> fours_;
};

/// The part of a box with width and height in a cell, if they overlap.
/// @param per_area  of the box, 1/m2
inline std::optional<BoxPart> part_in(const BasisCell& cell, const mesh::Rectangle& box, double per_area) {
  const mesh::Rectangle& all = cell.all;
  const mesh::Rectangle part{std::max(all.x_min, box.x_min), std::max(all.y_min, box.y_min),
                             std::min(all.x_max, box.x_max), std::min(all.y_max, box.y_max)};
  if (!(part.x_min < part.x_max && part.y_min < part.y_max))
    return std::nullopt;
  return BoxPart{part.area() * per_area, (0.5 * (part.x_min + part.x_max) - all.x_min) * cell.per_h,
                 (0.5 * (part.y_min + part.y_max) - all.y_min) * cell.per_h};
}

} // namespace tremolo::mpm_domain
