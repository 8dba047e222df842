#pragma once

// The length of a step. Soil of wave speed c_p on cells of size h is stable for
//
//     dt <= 0.65 h / (c_p + |v|)                                  (spec/limits.hpp).
//
// Below the water table the speed is that of grains and water without drag where water flows, and that of
// both together where it does not (wave_speed.hpp). Permeability does not limit the step. With viscous
// damping of the time beta the limit dt becomes sqrt(dt^2 + beta^2) - beta (damped_step there). A matched
// layer below the base whose ground is not the soil has the limit above with v = 0. Where levels take steps
// of their own, soil on clock r allows clock 0 a step 2^r times as long.

#include "mpm_domain/domain.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// Bounds on the step, two numbers by set, then by lattice, then by clock: the speed of the fastest waves
/// (m/s; -1 if there are no particles), and the longest damping time (s). The bounds of several ranks
/// together are the largest ones.
using StepBounds = std::vector<double>;

/// Speed of the fastest of all particles and points of structures of all ranks, m/s: none may go far from one
/// sort to the next.
double fastest_point(const Domain& domain);

/// The bounds of the particles of this rank.
StepBounds step_bounds(Domain& domain);

/// The critical time step of this rank if all particles take the same, s.
double critical_time_step(Domain& domain, double max_speed);

/// The critical step for constant pore pressures, as under gravity, s.
double critical_skeleton_step(Domain& domain);

/// The next step, s: the fixed step of the scheme, or its fraction of the critical step. Where levels take
/// steps of their own it is that of clock 0, so that every clock keeps to the limit of its own particles and
/// no particle comes near cells of another level before the next sort. A last step that is still close to
/// this is kept, since leapfrog is of second order only while the step stays the same.
/// @param bounds of the particles of all ranks
/// @param last the step before, 0 if there was none
/// @throws std::invalid_argument for a step over the limit
double next_time_step(const Domain& domain, const StepBounds& bounds, double max_speed, double last);

} // namespace tremolo::mpm_domain
