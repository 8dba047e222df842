#pragma once

#include "coupler/participant.hpp"

namespace tremolo::coupler {

/// The main of a participant for tests.
int toy_process(const CommandLine& command, const Surroundings& surroundings);

} // namespace tremolo::coupler
