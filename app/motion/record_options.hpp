#pragma once

// Options by which a command learns the contents of a motion file.

#include "app/command_line.hpp"
#include "motion/read/read.hpp"

#include <string>

namespace tremolo::app {

/// The files that can be read, as the texts of options name them.
inline constexpr const char* record_formats = "PEER, K-NET, SMC, COSMOS, CSMIP, GeoNet, ESM and other "
                                              "networks' texts, a table of time and values, or HDF5";

/// Properties that the file may leave open; empty if not given.
struct RecordOptions {
  std::string quantity;
  std::string unit;
  std::string component;
  std::string column;
};

/// --quantity, --unit, --component and --column.
void add_record_options(Command& command, RecordOptions& options);

/// @throws std::invalid_argument for a quantity or unit that is not known
motion::ReadAs read_as(const RecordOptions& options);

} // namespace tremolo::app
