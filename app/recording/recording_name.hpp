#pragma once

#include "scene/case.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace tremolo::app {

/// A recording as a command line names it.
struct RecordingName {
  std::filesystem::path file;
  std::optional<scene::Side> side; ///< of a recorded exchange
  bool domain = false;             ///< of a recorded exchange: what the domain gave back
  bool exchange = false;           ///< whether it is the recorded exchange of a run
};

/// "RUN:left", "RUN:right", "RUN:base" or "RUN:domain", where RUN is a run's folder or its exchange.h5; RUN
/// alone; or the file of a recorded free field.
/// @throws std::runtime_error where there is no such file, or the run was not recorded
RecordingName recording_named(const std::string& text);

} // namespace tremolo::app
