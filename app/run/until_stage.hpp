#pragma once

// The stage that `run` and `resume` are asked to end after.

#include "app/command_line.hpp"
#include "coupler/hub/checkpoint_set.hpp"
#include "scene/case.hpp"

#include <string>

namespace tremolo::app {

/// @param until  outlives the command
void add_until_option(Command& command, std::string& until);

/// Refuses to end after a stage that is not there, or that leaves nothing to go on from.
/// @param until  name of the stage; empty: the last one
/// @throws std::invalid_argument
void check_until(const scene::Case& scene, const std::string& until);

/// Refuses a stage that was over when the checkpoint was made, too.
/// @throws std::invalid_argument
void check_until(const scene::Case& scene, const std::string& until, const coupler::CheckpointSet& set);

} // namespace tremolo::app
