#pragma once

#include <filesystem>

namespace tremolo {

/// The folder for temporary ones: $TMPDIR, or /tmp.
/// @throws std::runtime_error naming it if it is none
std::filesystem::path temporary_parent();

} // namespace tremolo
