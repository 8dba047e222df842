#pragma once

// A straight beam element between two nodes that turns with its chord (co-rotational: Crisfield 1991, chapter
// 7) and shears (Timoshenko). With l_0 and l its lengths at the start and now, beta the turn of its chord and
// theta_a, theta_b those of its ends since the start,
//
//     e = (l - l_0, theta_a - beta, theta_b - beta) + e_0,        (N, M_a, M_b) = D e,
//
//     N = EA (l - l_0)/l_0,     [M_a]   EI/l_0   [4 + P  2 - P] [theta_a - beta]
//                               [M_b] = ------ * [2 - P  4 + P] [theta_b - beta],     P = 12 EI/(GA_s l_0^2),
//                                       1 + P
//
// and the forces on its degrees of freedom (x, y, theta of a, then of b) are B^T (N, M_a, M_b), B = de/dq.
// P = 0 is Euler-Bernoulli. e_0 is the strain that the element had when it stood as at the start. The turn
// theta goes on over full turns; local rotations stay below half a turn.

#include "mpm_domain/spec/lining.hpp"
#include "mpm_domain/spec/section.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace tremolo::mpm_domain {

using ElementStrain = std::array<double, 3>; ///< m, rad, rad
using ElementForce = std::array<double, 3>;  ///< N/m, N, N: per metre out of plane

struct BeamElement {
  std::array<std::size_t, 6> dofs{}; ///< x, y, theta of a, then of b
  double length = 0.0;               ///< l_0, m
  double angle = 0.0;                ///< of the chord at the start, rad
  ElementStrain strain_before{};     ///< e_0
};

/// Present position of an element.
struct ElementPosition {
  Vector axis;         ///< along the chord, from a to b
  double length = 0.0; ///< l, m
  ElementStrain strain{};

  /// B.
  std::array<std::array<double, 6>, 3> strain_rows() const;
};

/// @param q  of the beam
ElementPosition position_of(const BeamElement& element, std::span<const double> q);

/// D.
std::array<std::array<double, 3>, 3> stiffness_of(const BeamElement& element, const BeamSection& section);

/// D e.
ElementForce force_of(const BeamElement& element, const BeamSection& section, const ElementStrain& strain);

/// The section forces at the middle of an element under (N, M_a, M_b): Q = -(M_a + M_b)/l, M = (M_b - M_a)/2.
SectionForces in_the_middle(const ElementForce& force, double length);

} // namespace tremolo::mpm_domain
