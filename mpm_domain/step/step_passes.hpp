#pragma once

// Passes at the beginning and the end of a step: its length (time_step.hpp), the sort, and the messages
// between ranks.
//
// Particles are sorted before any of them may have moved farther than weights and windows reach,
//
//     sum of max|v| dt since the last sort < sort distance.

#include "mpm_domain/domain.hpp"
#include "mpm_domain/passes/pass.hpp"

#include <vector>

namespace tremolo::mpm_domain {

std::vector<Pass> step_passes(Domain& domain);

} // namespace tremolo::mpm_domain
