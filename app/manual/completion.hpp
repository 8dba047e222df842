#pragma once

#include "app/manual/command_table.hpp"

#include <string>

namespace tremolo::app {

// Completion script for shells: commands first, then a command's options and the values of those that have a
// list; file names elsewhere.

std::string bash_completion(const CommandTable& table);
std::string zsh_completion(const CommandTable& table);
std::string fish_completion(const CommandTable& table);

} // namespace tremolo::app
