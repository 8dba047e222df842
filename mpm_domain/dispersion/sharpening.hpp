#pragma once

// Waves on a grid of hat functions are too slow: a strain read from it is smaller than that of the wave by
// gamma (k h)^2/2, and so is the force that it causes. Both are sharpened by second differences. With
//
//     D_d v = 2 v_I - v_{I+d} - v_{I-d},      D_xy v = (v_{I+x-y} + v_{I-x+y} - v_{I+x+y} - v_{I-x-y})/4
//
// and chi as in fullness.hpp, strains are those of the velocity Q v, and internal forces f0 become f,
//
//     (Q v)_a = v_a + sum_d (q1_ad chi_d D_d v_a + q2 D_d (chi_d D_d v_a)) + q3 chi_xy D_xy v_b,      b != a,
//     f = Q^T f0,      q1_ad = q1 + q3 for d = a, else q1.
//
// Q^T is the adjoint of Q, so that forces and strains exchange exactly the energy of the stresses, as before.
// Differences of a linear field are zero: Q leaves linear velocities alone, and Q^T leaves the sum of all
// forces and their torque. Weight, tractions and dashpots are not internal forces and are not sharpened. q1
// and q2 are such that the terms of (k h)^2 cancel for P and S waves in all directions together with the wide
// boxes of transfer/wide_squares.hpp, less what the time step adds; q3, which acts on waves that change
// volume alone, makes up for the longer way that P waves go in a step:
//
//     q1 = 0.1255 - (dt c_s/h)^2/24,      q2 = 0.022,      q3 = -(dt/h)^2 (c_p^2 - c_s^2)/24,
//
// with the step that is planned for soil in its first state, and the speeds of the soil whose waves are
// slowest.

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

struct Sharpening {
  double first = 0.0;    ///< q1
  double second = 0.0;   ///< q2
  double dilation = 0.0; ///< q3
};
Sharpening sharpening_of(const Ground& ground);

/// Writes Q v of all nodes into sharp_x and sharp_y. Tied nodes have their velocities already.
void sharpen_velocities(Ground& ground, const NodeField& vx, const NodeField& vy);

/// Turns the internal forces of the nodes, f0, whose tied ones have been folded, into Q^T f0 and adds the
/// weight.
void sharpen_forces(Ground& ground);

} // namespace tremolo::mpm_domain
