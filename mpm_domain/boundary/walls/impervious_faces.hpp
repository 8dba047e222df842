#pragma once

// Impervious faces of soil whose water flows: no pressure drives water through the boundary of the domain.
//
// Base: no water passes, w . n = 0. The nodes on a face's line, and those next to it outside, are closed.
// Where the line lies within a cell, the nodes on its inner side are open. They feel the force of the excess
// pressure in the soil up to the line, f = sum V p_e grad S, and need the reaction of the wall there,
//
//     f_i -= sum over faces 2l W_i p_e n,
//
// with the weights W of the boundary (boundary_faces.hpp), whose tractions balance a uniform stress exactly.
// Without it, a pressure beside the line would drive water out through the nodes until it had fallen to the
// share of the cell that the soil fills.
//
// Sides: the same reaction at all nodes, none of which is closed. In level ground that is shaken grains and
// water move past each other along x, w = -(k/g) a, for the drag is all that takes the water along, and the
// ground beyond a side is no wall: where w . n = 0, pressures rise and fall by rho_f a over the way that they
// drain in a cycle. With the reaction p_e n water beside a side feels no gradient across it, and passes as
// fast as everywhere. Where the side leans, the reaction has a part along y (lean/leaning_sides.hpp).
//
// The walls of a container are closed, as the base is.

#include "mpm_domain/boundary/boundary.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// The walls stand during the update of the nodes alone. They close before it, when the reactions of the
/// faces are added to the forces on water; when its work is booked, they are taken off again, and the forces
/// are those of the pressure in the soil alone. Their work on the flow n w is what the ground beyond gives,
/// which the update has booked as dissipated by drag too.
std::vector<Pass> wall_passes(Ground& ground, const Boundary& boundary);

} // namespace tremolo::mpm_domain
