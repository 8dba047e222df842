#pragma once

#include "scene/text/findings.hpp"

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace tremolo::scene {

/// @throws CaseErrors where the file is not there or cannot be read
std::string read_text(const std::filesystem::path& file);

/// @throws CaseErrors for a text that is not TOML, with what has been found before
toml::table parse_toml(std::string_view text, Findings& findings);

} // namespace tremolo::scene
