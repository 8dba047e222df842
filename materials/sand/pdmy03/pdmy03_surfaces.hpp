#pragma once

// The nested cones and the stress-strain curve they share. At the reference pressure the backbone is a
// hyperbola in octahedral shear,
//
//     tau(gamma) = G_r gamma/(1 + gamma/gamma_r),    tau(gamma_max) = tau_f = sqrt 2 H_r M_f/3,
//
// cut into N equal steps of stress, tau_i = i tau_f/N and M_i = i M_f/N; or a measured curve in simple shear,
// tau_i = G_r (G/Gmax)_i gamma_i and M_i = sqrt 3 tau_i/H_r. Between points i and i+1 surface i is active,
// with
//
//     E_i = 2 (tau_i+1 - tau_i)/(gamma_i+1 - gamma_i),    H'_i = 2 G_r E_i/(2 G_r - E_i),    H'_N = 0
//
// (Prevost 1985; Elgamal, Yang, Parra & Ragheb 2003, Int. J. Plasticity 19, 883-905).

#include "materials/sand/pdmy03/pdmy03.hpp"

#include <span>

namespace tremolo::materials {

/// Slope M of a cone in q-p, from a friction angle (rad).
double cone_ratio(Pdmy03Cone cone, double friction);

/// The friction angle (rad) of a cone's slope; the inverse of cone_ratio().
/// @throws std::invalid_argument for a slope that no angle has
double cone_friction(Pdmy03Cone cone, double ratio);

/// Sets all that follows from the parameters: surfaces of the hyperbola.
/// @throws std::invalid_argument where the curve cannot reach the strength
void build_surfaces(Pdmy03& law, std::size_t count);

/// Surfaces of a measured curve, which also sets the friction angle.
/// @throws std::invalid_argument for points that are not a curve of decreasing stiffness
void build_surfaces(Pdmy03& law, std::span<const ModulusReduction> curve);

} // namespace tremolo::materials
