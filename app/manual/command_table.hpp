#pragma once

// The commands and options as a table, from which man pages, shell completions and the page of commands are
// written.

#include <string>
#include <vector>

namespace tremolo::app {

/// An option, or an argument that has a place instead of a name.
struct OptionRow {
  std::vector<std::string> names; ///< "-h", "--help"; the one name of an argument
  std::string value;              ///< what follows the option, with its range; empty for a flag
  std::string description;
  std::vector<std::string> choices; ///< all values that are allowed; empty where they cannot be listed
  bool has_place = false;           ///< an argument
  bool required = false;
};

/// A command of the program.
struct CommandRow {
  std::string name;
  std::string description;
  std::string footer; ///< what its help ends with
  std::vector<OptionRow> options;
  bool relay = false; ///< the Python package takes the options
};

/// The program with all its commands.
struct CommandTable {
  std::string program;
  std::string description;
  std::vector<CommandRow> commands;
};

} // namespace tremolo::app
