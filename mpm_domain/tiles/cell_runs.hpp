#pragma once

// Runs of particles that stand one after the other, lie in one cell and touch the same nodes. All that a
// value e of the cell brings to node i with weights W, and all that the cell takes from values e_i of nodes,
//
//     sum_p W_p S_ip e = M_i e,      sum_p W_p sum_i S_ip e_i = sum_i M_i e_i,
//
// needs of the particles only their shares M_i = sum_p W_p S_ip, which are added up once a step.

#include "mpm_domain/kernel/lanes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct CellRun {
  std::size_t end;    ///< the particle after its last
  std::int32_t first; ///< where the first of its nodes stands in the window of the tile
  std::int32_t cell;  ///< where the cell's lower left node stands there
  double weight;  ///< sum W when the sums in cells begin: in a static stage particles have strained by then
  double product; ///< sum W e of values e that differ from particle to particle, likewise
};

/// The runs of the particles of a set in a tile, in their order. Each has four shares a row of nodes.
class CellRuns {
public:
  /// @param rows  of nodes that a run has
  void restart(std::size_t rows) {
    rows_ = rows;
    count_ = 0;
  }
  /// Makes room for so many more runs. It is kept when the runs restart.
  void expect(std::size_t more) {
    if (runs_.size() >= count_ + more)
      return;
    runs_.resize(count_ + more);
    shares_.resize(rows_ * runs_.size());
  }
  template <std::size_t rows>
  [[gnu::always_inline]] void add(std::size_t end, std::int32_t first, std::int32_t cell,
                                  const std::array<Lanes, rows>& shares) {
    for (std::size_t j = 0; j < rows; ++j)
      shares_[count_ * rows + j] = shares[j];
    runs_[count_++] = {end, first, cell, 0.0, 0.0};
  }

  std::span<CellRun> all() { return std::span(runs_).first(count_); }
  std::span<const CellRun> all() const { return std::span(runs_).first(count_); }
  /// The rows of shares of all runs, one after the other.
  const Lanes* shares() const { return shares_.data(); }

private:
  std::size_t rows_ = 0;
  std::size_t count_ = 0;
  std::vector<CellRun> runs_;
  std::vector<Lanes> shares_;
};

} // namespace tremolo::mpm_domain
