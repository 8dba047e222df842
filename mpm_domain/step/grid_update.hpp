#pragma once

#include "mpm_domain/domain.hpp"

#include <span>

namespace tremolo::mpm_domain {

/// v- = p/m at every node; nodes without soil rest.
/// @returns the grid's kinetic energy, J/m
double grid_velocities(Domain& domain);
/// The same on some nodes alone; tied ones are left.
double grid_velocities(Domain& domain, std::span<const NodeRange> nodes);

/// Replaces v- by the velocity that the particles' new momenta give the node; v+ stays. For musl.
/// @returns power of the nodal forces, weight aside, on what v+ differs from the remapped velocity by, W/m
double remap_velocities(Domain& domain);
/// The same on some nodes alone; tied ones are left.
double remap_velocities(Domain& domain, std::span<const NodeRange> nodes);

/// What the grid update adds up, J/m.
struct GridUpdate {
  double kinetic = 0.0; ///< K(v+)
  double gravity_work = 0.0;
  double dashpot_relief = 0.0; ///< work of -C (v+ - v-)/2, the implicit part of the lumped dashpots
};

/// v+ from (m/dt + C/2) (v+ - v-) = f, with C the boundary dashpots lumped to the node.
///
/// f holds the dashpots of v- in full, so this is the centred form, -C (v+ + v-)/2, for a lone node. However
/// small the mass of a node, |v+ - v-| stays below 2 |f|/C: a boundary node that has lost nearly all its soil
/// remains stable.
GridUpdate update_grid(Domain& domain, double dt);
/// The same on some nodes alone; tied ones are left.
GridUpdate update_grid(Domain& domain, double dt, std::span<const NodeRange> nodes);

/// Reads face velocities v^m_f = sum_i W_if v_i (m/s), before (v-) the update.
void face_velocities(Domain& domain, std::span<const FaceWeights> weights, std::span<Vector> v);

/// The same of v = (v- + v+)/2.
void face_mid_velocities(Domain& domain, std::span<const FaceWeights> weights, std::span<Vector> v);

/// Adds tractions (Pa) to nodal forces and lumps the faces' dashpots to the nodes.
void spread_tractions(Domain& domain, std::span<const FaceWeights> weights,
                      std::span<const Vector> tractions);

/// Lumps the faces' share of matched layers to the nodes: update_grid then moves soil and layer as one mass.
void spread_layer_mass(Domain& domain, std::span<const FaceWeights> weights, double dt);

} // namespace tremolo::mpm_domain
