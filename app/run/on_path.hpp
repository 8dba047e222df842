#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

namespace tremolo::app {

/// The file of a program that the shell would find; empty if there is none.
inline std::filesystem::path on_path(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const auto file = std::filesystem::path(folder) / program; ::access(file.c_str(), X_OK) == 0)
      return file;
  return {};
}

} // namespace tremolo::app
