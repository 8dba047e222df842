#pragma once

#include <filesystem>

namespace tremolo::app {

/// Refuses, before the work is done, a file that could not be written after it.
/// @throws std::runtime_error naming the file and what is in its way
void require_writable(const std::filesystem::path& out);

} // namespace tremolo::app
