#pragma once

// The undisturbed water, p_0 = gamma (h - y) below the phreatic surface, presses on the outer face of a
// lining from all sides, as a pressure that follows it: along an edge from a to b of the outline,
//
//     f = integral of p_0 n ds,      n into the lining,
//
// by two Gauss points an edge, each of which the beam carries as it carries contact (surface.hpp). Where p_0
// is linear in place, force and moment are exact. All edges together lift the lining by the weight of the
// water in its place. The inside holds air. The excess pressure comes through contact (water_before.hpp).

#include "mpm_domain/lining/beam/beam.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

/// p_0 at a point, Pa; without water, and above its surface, zero.
double rest_pressure(const Ground& ground, const Vector& at);

/// Adds the forces on the degrees of freedom of a beam, N/m and N.
/// @param outline  of the outer face now; its edges lie before the elements, m
void add_rest_pressure(const Ground& ground, std::span<const Vector> outline, const Beam& beam,
                       std::span<double> forces);

} // namespace tremolo::mpm_domain
