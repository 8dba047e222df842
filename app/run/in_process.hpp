#pragma once

// A run within one process: every participant is a thread of it, with the same main as its program.

#include "coupler/client/participant_options.hpp"

#include <string>

namespace tremolo::app {

/// The main of one of our programs.
/// @throws std::invalid_argument for a program of the user, which is a process of its own
coupler::ParticipantMain main_of(const std::string& program);

/// Lets several of them run in one process. To be called before they start.
/// @throws std::runtime_error where a library that they share cannot be used by several threads
void share_process();

} // namespace tremolo::app
