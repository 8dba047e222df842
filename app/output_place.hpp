#pragma once

#include <filesystem>

namespace tremolo::app {

/// Refuses, before the work is done, a file that could not be written after it.
/// @throws std::runtime_error naming the file and what is in its way
void require_writable(const std::filesystem::path& out);

/// Makes a folder with those above it, where they are not there yet.
/// @returns whether it was made
/// @throws std::runtime_error naming the folder and what is in its way
bool make_folder(const std::filesystem::path& folder);

} // namespace tremolo::app
