#pragma once

// Operations on the nodes between the transfers. All functions work on the rows of nodes that they are given;
// tied nodes are left alone (grid/tied_nodes.hpp). What they return are sums of one rank.

#include "mpm_domain/tiles/totals.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// v- = p/m; nodes without soil rest.
/// @returns the nodes' kinetic energy, J/m
ExactSums<1> grid_velocities(Ground& ground, std::span<const NodeRange> nodes);

/// u = p/m of the particles' new momenta, the velocity that strains the soil. For musl.
/// @returns power of the nodal forces, weight aside, on what v+ differs from u by, W/m
ExactSums<1> remap_velocities(Ground& ground, std::span<const NodeRange> nodes);

/// Energies summed during the update of nodes, J/m.
struct GridUpdate {
  double kinetic; ///< K(v+)
  double gravity_work;
  double dashpot_relief; ///< work of -C (v+ - v-)/2, the implicit part of the lumped dashpots

  explicit GridUpdate(const std::array<double, 3>& totals)
      : kinetic(totals[0]), gravity_work(totals[1]), dashpot_relief(totals[2]) {}
};

/// v+ from (m/dt + C/2) (v+ - v-) = f, with C the boundary dashpots lumped to the node.
///
/// f holds the dashpots of v- in full, so this is the centred form, -C (v+ + v-)/2, for a lone node. However
/// small the mass of a node, |v+ - v-| stays below 2 |f|/C: a boundary node that has lost nearly all its soil
/// remains stable.
/// @param dt time that the forces act for, s
/// @returns the parts of a GridUpdate
ExactSums<3> update_grid(Ground& ground, double dt, std::span<const NodeRange> nodes);

} // namespace tremolo::mpm_domain
