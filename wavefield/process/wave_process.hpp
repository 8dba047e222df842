#pragma once

#include "coupler/participant.hpp"

namespace tremolo::wavefield {

/// The main of tremolo-wave: the exact free field of an oblique wave.
int wave_process(const coupler::CommandLine& command, const coupler::Surroundings& surroundings);

} // namespace tremolo::wavefield
