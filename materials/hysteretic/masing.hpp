#pragma once

// Shear stress of one point under irregular cyclic strain by the extended Masing rules (Pyke 1979, J.
// Geotech. Eng. 105(6), 715-726; Vucetic 1990, Can. Geotech. J. 27, 29-44), F the backbone:
//
//     1  first loading follows the backbone,                       tau = F(gamma);
//     2  after a reversal at (gamma_r, tau_r) the curve is doubled, tau = tau_r + 2 F((gamma - gamma_r)/2);
//     3  beyond the largest past |gamma| it is the backbone again;
//     4  a curve that meets the curve of an earlier loop goes on along that one.
//
// With less damping in loops than these rules have (loop_reduction.hpp) the stress is F tau_M + (1 - F) G_m
// gamma, tau_M that of the rules. The history below holds tau_M; gamma_m is the strain at its oldest
// reversal.
//
// Rule 4 asks for the reversal points of all loops that are still open: a stack. A reversal pushes a point;
// passing the last but one point closes a loop and pops two.
//
// The stack is finite. When it is full, a reversal replaces the two innermost points: the smallest two loops
// become one. The point keeps its stress and its damping; lost is where inside the smallest loop that is
// still remembered the forgotten ones closed. Until that loop closes, the stress is off by no more than the
// loop is thick, 2 [2 F(d/4) - F(d/2)] for a loop of width d; outside of it all is exact again. It takes
// `masing_capacity` reversals each smaller than the one before, and is counted in the history.

#include "materials/hysteretic/backbone/backbone.hpp"

#include <cstddef>
#include <span>

namespace tremolo::materials {

/// Reversal points that a history holds.
inline constexpr std::size_t masing_capacity = 32;

/// Entries of a history block before the reversal points { strain, stress (Pa) }, the oldest first.
namespace masing {
inline constexpr std::size_t strain = 0;    ///< accepted strain, from the state of zero history
inline constexpr std::size_t stress = 1;    ///< its stress by the Masing rules, Pa
inline constexpr std::size_t reversals = 2; ///< number of reversal points held
inline constexpr std::size_t merged = 3;    ///< 1 while the innermost point represents forgotten ones, else 0
inline constexpr std::size_t merges = 4;    ///< how often the stack was full, since the start
inline constexpr std::size_t first_point = 5;
} // namespace masing

inline constexpr std::size_t masing_history_size = masing::first_point + 2 * masing_capacity;

/// The block of doubles that is a point's history. All zero: never loaded.
using MasingHistory = std::span<const double, masing_history_size>;
using MutableMasingHistory = std::span<double, masing_history_size>;

/// Strain changes smaller than this are no change: masing_commit() ignores them.
inline constexpr double least_strain_change = 1e-14;

/// The response if the strain went straight from its accepted value to `strain`. The history is unchanged, so
/// any number of trials may be made (Newton iterations, stages of a Runge-Kutta step). Continuous in
/// `strain`. At the accepted strain itself the tangent is that of going on in the same direction; that of
/// turning back is G0.
ShearResponse masing_response(const Backbone& backbone, MasingHistory history, double strain);

/// The stress of masing_response(), Pa
double masing_stress(const Backbone& backbone, MasingHistory history, double strain);

/// The tangent of masing_response(), Pa
double masing_tangent(const Backbone& backbone, MasingHistory history, double strain);

/// The stress at the accepted strain, Pa.
double accepted_stress(const Backbone& backbone, MasingHistory history);

/// Accepts a strain: the history goes straight from its accepted strain to this one. Its stress afterwards is
/// what masing_stress() gave for it before.
void masing_commit(const Backbone& backbone, MutableMasingHistory history, double strain);

/// Whether going to `strain` would turn back from the direction in which the accepted strain was reached.
bool masing_reverses(MasingHistory history, double strain);

} // namespace tremolo::materials
