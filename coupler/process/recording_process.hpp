#pragma once

#include "coupler/participant.hpp"

namespace tremolo::coupler {

/// The main of tremolo-recording: a recorded free field.
int recording_process(const CommandLine& command, const Surroundings& surroundings);

} // namespace tremolo::coupler
