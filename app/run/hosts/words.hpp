#pragma once

// The words of commands that start processes, and their parts.

#include <filesystem>
#include <string>
#include <vector>

namespace tremolo::app {

using Words = std::vector<std::string>;

/// A variable of the environment; empty without it.
std::string environment(const char* name);

/// The file of a program that the shell would find; empty if there is none.
std::filesystem::path on_path(const std::string& program);

/// The file of a program that [hosts] requires.
/// @throws std::runtime_error if there is none
std::string found_on_path(const std::string& program);

/// A text's words between its blanks.
Words words_of(const std::string& text);

Words joined(Words words, const Words& more);

} // namespace tremolo::app
