#pragma once

#include "app/manual/command_table.hpp"

namespace tremolo::app {

/// Gives the commands that the Python package serves the options that it takes for them.
/// @throws std::runtime_error where the package does not say
void add_python_options(CommandTable& table);

} // namespace tremolo::app
