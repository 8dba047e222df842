#pragma once

// The transfers of a domain with reduced dispersion that differ from the plain ones: internal forces go to
// the nodes by the wide boxes and are sharpened, and the velocity that strains the soil is sharpened before
// it is read in the wide boxes. Both need the fullness of the nodes (dispersion/fullness.hpp).

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

/// f = Q^T f0 + m g,  f0_i = - sum_p V_p sigma_p G_ip, of all nodes.
void scatter_sharp_forces(Ground& ground);

/// The velocity that strains becomes Q u.
void sharpen_strain(Ground& ground);

/// A field of the nodes, velocity or acceleration, at particle k of a set. A mean with the weights S alone
/// would be too small by D_d (k_d/h)^2/2 in a wave, D_d the second moment of S: the mean is that of
///
///     v + sum_d D_d/(2 h^2) chi_d (2 v_I - v_{I+d} - v_{I-d}).
Vector sharp_reading(const Ground& ground, const Particles& particles, std::size_t k,
                     const NodeField& field_x, const NodeField& field_y);

} // namespace tremolo::mpm_domain
