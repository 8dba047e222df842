#pragma once

#include "app/manual/command_table.hpp"

#include <string>

namespace tremolo::app {

/// The page man(1) shows for the program: its commands and the files it reads.
/// @param version  "tremolo 0.1.0", in the page's foot
std::string man_page(const CommandTable& table, const std::string& version);

/// The page of one command, `man PROGRAM-COMMAND`.
std::string man_page(const CommandTable& table, const CommandRow& command, const std::string& version);

} // namespace tremolo::app
