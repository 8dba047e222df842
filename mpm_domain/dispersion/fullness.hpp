#pragma once

// A smooth indicator of the soil's surface. The fullness of the neighbourhood of a node,
//
//     e = min(1, m/(0.45 rho h^2)),      rho of the lightest soil,
//
// is 1 at nodes of a free surface that lies on a line of the grid, whose cells are half full, also if they
// move a little, and falls to 0 with the node's mass. A
// second difference along x or y has a place at a node only as far as soil lies on both sides of it:
//
//     chi_d = min(e_{I-d}, e_I, e_{I+d}),
//
// and chi_xy, the least e of the node and its eight neighbours, for differences along x and y.
//
// All is a continuous function of the masses, so that nothing jumps while soil moves through the grid.

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

/// Finds e and chi from the masses of the nodes, whose tied ones have been folded. Near the edge of the grid,
/// where no soil comes, chi is zero.
void find_fullness(Ground& ground);

} // namespace tremolo::mpm_domain
