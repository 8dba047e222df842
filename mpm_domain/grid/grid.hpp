#pragma once

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/spec/lattice.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::mpm_domain {

/// One double a node, row after row.
using NodeField = std::vector<double>;

/// The background grid: its nodes' fields, and the place of the coarsest nodes. A graded mesh has more
/// lattices, whose nodes stand behind these in every field; on a uniform one the grid is this lattice alone.
struct Grid : Lattice {
  /// Columns after which the grid repeats itself, from column `first_column` on; 0: it does not.
  int period = 0;
  int first_column = 0;

  // What particles and faces add up in one step.
  NodeField mass;                   ///< kg/m
  NodeField momentum_x, momentum_y; ///< kg/s
  NodeField force_x, force_y;       ///< N/m
  NodeField dashpot_x, dashpot_y;   ///< boundary dashpots lumped to the node, Pa s

  NodeField vx, vy;         ///< velocity before the update, or remapped after it, m/s
  NodeField vx_new, vy_new; ///< after the update, m/s
  NodeField ax, ay;         ///< acceleration of the last update, m/s2

  /// The column that column i stands for: itself, or the one of the period that it is an image of.
  int real_column(int i) const {
    if (period == 0)
      return i;
    const int beyond = (i - first_column) % period;
    return first_column + (beyond < 0 ? beyond + period : beyond);
  }
  std::size_t size() const { return mass.size(); }
  /// Velocities before and after the update.
  eq6::Vector velocity(std::size_t n) const { return {vx[n], vy[n]}; }
  eq6::Vector new_velocity(std::size_t n) const { return {vx_new[n], vy_new[n]}; }
  eq6::Vector acceleration(std::size_t n) const { return {ax[n], ay[n]}; }
};

} // namespace tremolo::mpm_domain
