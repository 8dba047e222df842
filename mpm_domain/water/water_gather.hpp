#pragma once

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

/// Water velocities of particles from the grid, as gather() does for the grains: with APIC v_f = sum S v_f+
/// and its B, with FLIP v_f += sum S (v_f+ - v_f-). The water moves through the grains: particles stay with
/// these.
void gather_water(Ground& ground);

/// Velocities of grains and of water that flows, of the particles of a set in a tile that touch its lattice
/// alone.
void gather_mixture(Ground& ground, Particles& particles, std::size_t tile);
/// Gathers for particles that touch several lattices.
void gather_mixture(Ground& ground, const AcrossTile& tile);

} // namespace tremolo::mpm_domain
