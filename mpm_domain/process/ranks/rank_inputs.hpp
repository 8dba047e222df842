#pragma once

#include "coupler/participant.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

namespace tremolo::mpm_domain {

/// Ranks on several machines might be of different builds, and a file need not hold there what it holds here.
/// Called by all ranks, before they compute anything.
/// @throws std::runtime_error on a rank whose build, case, data files or checkpoint is not that of rank 0
void require_same_inputs(Communicator& ranks, const scene::Case& scene, const scene::Plan& plan,
                         const coupler::ParticipantOptions& options);

} // namespace tremolo::mpm_domain
