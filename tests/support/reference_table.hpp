#pragma once

#include "tests/support/paths.hpp"

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace tremolo::testing {

/// Folder of the reference data: TREMOLO_REFERENCE, else ../shared/reference beside the source tree.
inline std::filesystem::path reference_folder() {
  const char* folder = std::getenv("TREMOLO_REFERENCE");
  return folder ? std::filesystem::path(folder)
                : std::filesystem::path(source_dir()) / ".." / "shared" / "reference";
}

/// The numeric rows of a comma-separated file; comment lines (#) and the line of names are left out.
inline std::vector<std::vector<double>> read_table(const std::filesystem::path& file) {
  std::vector<std::vector<double>> rows;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.find_first_of("0123456789+-.") != 0) {
      continue;
    }
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(std::stod(cell));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

} // namespace tremolo::testing
