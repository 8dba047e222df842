#pragma once

// Soil that comes to ground which has moved. Its polygon is in present coordinates, and particles are laid in
// it on the lattice of the model, as at the start. Where ground has come into the polygon none is laid; where
// the ground under it has gone down, so that a gap would be left between them, soil fills the gap too. It
// begins with the stress of its own weight,
//
//     s_yy = -gamma (depth below the top of what is placed with it),      s_xx = s_zz = K0 s_yy.

#include "mpm_domain/ground.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The particles of a region that is placed now, by the sets of the ground; they are not in it yet. All ranks
/// that share the ground call it, and take all of them.
/// @throws std::invalid_argument for a region in which no particle lies, or one below the water
std::vector<Particles> soil_to_place(const Ground& ground, const Region& region);

} // namespace tremolo::mpm_domain
