#pragma once

#include <cstddef>

namespace tremolo::mpm_domain {

/// A regular block of nodes, row after row. Node (i, j) lies at (x0 + i h, y0 + j h).
struct Lattice {
  double h = 0.0;
  double x0 = 0.0;
  double y0 = 0.0;
  int nx = 0;            ///< nodes per row
  int ny = 0;            ///< rows
  std::size_t first = 0; ///< index of node (0, 0) in the arrays of all nodes

  std::size_t index(int i, int j) const {
    return first + static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
  }
  std::size_t count() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
};

/// Side of the square of a particle where cells of size h (m) hold `per_cell` of them in each direction, m.
constexpr double particle_size(double h, int per_cell) {
  return h / per_cell;
}

/// Nodes [begin, end) of a row.
struct NodeRange {
  std::size_t begin;
  std::size_t end;
};

} // namespace tremolo::mpm_domain
