#pragma once

// Assigns each particle its step when every level has its own: clock r ticks every dt_0/2^r. A particle takes
// the clock of the level of its cell, or a faster one near finer cells: within two cells of level r - 1
// around cells of level r all particles run on clock r. Without this buffer the forces of the slow clock, an
// impulse every other step, are in resonance with the fastest motion of the fine cells long before their own
// limit (measured in tests/stability/mpm_domain/subcycling_test.cpp).

#include "mesh/quadtree.hpp"

#include <cstdint>
#include <vector>

namespace tremolo::mpm_domain {

class ClockMap {
public:
  /// One clock for all.
  ClockMap() = default;
  /// @param buffer_layers  of cells of the coarser level around finer ones
  ClockMap(const mesh::Quadtree& tree, int buffer_layers);

  int count() const { return count_; }
  /// The clock of a particle at a point, m.
  int at(double x, double y) const;

private:
  int count_ = 1;
  double x0_ = 0.0, y0_ = 0.0, per_h_ = 0.0; ///< of the finest cells
  int nx_ = 0, ny_ = 0;
  std::vector<std::uint8_t> clock_; ///< of each finest cell, row by row
};

} // namespace tremolo::mpm_domain
