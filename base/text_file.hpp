#pragma once

#include <filesystem>
#include <string_view>

namespace tremolo::results {

/// Writes a text as a whole file, in place of one that is there.
/// @throws std::runtime_error with the file and the system's reason where it cannot be written
void write_text_file(const std::filesystem::path& file, std::string_view text);

} // namespace tremolo::results
