#pragma once

#include "coupler/participant.hpp"

namespace tremolo::freefield {

/// The main of tremolo-column: a laterally uniform free field.
int column_process(const coupler::CommandLine& command, const coupler::Surroundings& surroundings);

} // namespace tremolo::freefield
