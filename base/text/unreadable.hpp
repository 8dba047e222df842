#pragma once

#include <filesystem>
#include <string>

namespace tremolo {

/// Why a file cannot be opened for reading: "there is no such file", "cannot be read: this is a folder; give
/// the file in it", ...; empty if it can. To be asked before opening it: a pipe would wait for its other end.
std::string why_unreadable(const std::filesystem::path& file);

} // namespace tremolo
