#pragma once

#include "app/manual/command_table.hpp"

#include <string>

namespace tremolo::app {

/// The page of all commands with their arguments and options, Markdown.
std::string command_page(const CommandTable& table);

} // namespace tremolo::app
