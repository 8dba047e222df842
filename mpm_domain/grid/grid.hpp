#pragma once

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/fields/node_fields.hpp"
#include "mpm_domain/spec/grid_shape.hpp"

#include <cstddef>

namespace tremolo::mpm_domain {

/// The background grid: its nodes' fields, and the place of the coarsest nodes. A graded mesh has more
/// lattices, whose nodes stand behind these in every field; on a uniform one the grid is this lattice alone.
struct Grid : GridShape, NodeFields {
  NodeTraits traits; ///< of the domain: which fields there are

  /// The column that column i represents: itself, or the one of the period whose image it is.
  int real_column(int i) const {
    if (period == 0)
      return i;
    const int beyond = (i - first_column) % period;
    return first_column + (beyond < 0 ? beyond + period : beyond);
  }
  std::size_t size() const { return mass.size(); }
  eq6::Vector velocity_before(std::size_t n) const { return {vx_before[n], vy_before[n]}; }
  eq6::Vector velocity_after(std::size_t n) const { return {vx_after[n], vy_after[n]}; }
  eq6::Vector acceleration(std::size_t n) const { return {ax[n], ay[n]}; }
  /// Velocity of grains and water together, m/s.
  eq6::Vector mixture_before(std::size_t n) const {
    return traits.flowing ? together(n, velocity_before(n), {wx_before[n], wy_before[n]})
                          : velocity_before(n);
  }
  eq6::Vector mixture_after(std::size_t n) const {
    return traits.flowing ? together(n, velocity_after(n), {wx_after[n], wy_after[n]}) : velocity_after(n);
  }

private:
  eq6::Vector together(std::size_t n, eq6::Vector grains, eq6::Vector water) const {
    if (!(water_mass[n] > 0.0))
      return grains;
    const double share = water_mass[n] / (mass[n] + water_mass[n]);
    return grains + share * (water - grains);
  }
};

/// Sets the number of nodes and makes every field zero.
void resize(Grid& grid, int nx, int ny);

/// Sets the number of nodes of all lattices and makes every field zero.
void resize_fields(Grid& grid, std::size_t count);

} // namespace tremolo::mpm_domain
