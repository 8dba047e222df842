#pragma once

// The length of a step. Soil of wave speed c_p on cells of size h bears
//
//     dt <= 0.65 h / (c_p + |v|)                                  (spec/limits.hpp),
//
// with viscous damping of the time beta sqrt(dt^2 + beta^2) - beta, dt being the former (damped_step there);
// so does a matched layer of other ground below the base; and where levels take steps of their own, 2^r of
// that for clock 0, r being the clock of the soil.

#include "mpm_domain/domain.hpp"

namespace tremolo::mpm_domain {

/// The critical time step if all particles take the same, s.
double critical_time_step(Domain& domain, double max_speed);

/// The critical step of clock 0 where every clock keeps to the limit of its own particles, s. Nor may a
/// particle come near other cells within it, unsorted.
double critical_subcycled_step(Domain& domain, double max_speed);

/// The next step, s: what the scheme fixes, or its fraction of the critical step. A last step that is still
/// near that is kept, for leapfrog is second order only while the step stays the same.
/// @param last the step before, 0 if there was none
/// @throws std::invalid_argument for a step over the limit
double next_time_step(Domain& domain, double max_speed, double last);

} // namespace tremolo::mpm_domain
