#pragma once

// When constraints are removed, the tractions f^st of Eq. (6) take over what they held. They must give the
// nodes exactly the reactions R,
//
//     sum_f L_f W_if t_f = R_i      at every node i that was fixed, in every direction that was fixed,
//
// or the soil would start to move. There are more faces than nodes, so the tractions closest to the soil's
// own stress, t_f = sigma_p n plus the correction of least norm, are taken.

#include "mpm_domain/gravity/gravity_stage.hpp"

namespace tremolo::mpm_domain {

/// Sets the domain's static tractions from the reactions of its constraints; a rigid base and its walls stay
/// as they are, and hold the soil.
/// @returns the largest force left unbalanced at a node over the largest reaction
/// @throws std::runtime_error if the faces cannot hold the reactions to 1e-9
double replace_constraints(Domain& domain, const Reactions& reactions);

} // namespace tremolo::mpm_domain
