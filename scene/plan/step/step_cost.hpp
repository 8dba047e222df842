#pragma once

// CPU time of a step of the domain, of one thread on one x86-64-v3 core: what a particle costs for each of
// the effects that a case calls for, and what comes on top in every step,
//
//     t = sum over particles of ns + faces face_ns + ... .
//
// The numbers are those of the shipped cases (docs/performance.md, which compares estimate and run).

#include "scene/case.hpp"

namespace tremolo::scene::cost {

// What each effect costs for a particle, ns; materials/cost/update_cost.hpp has what laws cost.
inline constexpr double skeleton_ns = 50.0;
inline constexpr double boxes_ns = 15.0;
inline constexpr double dispersion_ns = 30.0;
inline constexpr double dilatation_ns = 12.0;
inline constexpr double damping_ns = 10.0;
inline constexpr double mechanism_ns = 5.0; ///< of constant damping
inline constexpr double pressure_ns = 25.0;
inline constexpr double flow_ns = 30.0;
inline constexpr double seepage_ns = 15.0;

/// What the laws of soils with a kind of response cost, ns, as a mean over all particles of the domain.
double law_ns(const Case& scene, materials::Response response);

/// What the boundary costs in a step, ns.
double boundary_ns(const Case& scene);

} // namespace tremolo::scene::cost
