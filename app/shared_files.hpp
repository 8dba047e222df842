#pragma once

#include <filesystem>

namespace tremolo::app {

/// A folder that this program needs besides itself: share/tremolo/NAME where it was installed, otherwise NAME
/// of the source tree it was built from.
/// @param name  "python" or "cases"
std::filesystem::path shared_folder(const char* name);

} // namespace tremolo::app
