#pragma once

#include "coupler/participant.hpp"

namespace tremolo::mpm_domain {

/// The main of tremolo-domain: the domain of a run, or a free field of its cells.
int domain_process(const coupler::CommandLine& command, const coupler::Surroundings& surroundings);

} // namespace tremolo::mpm_domain
