#pragma once

#include "tests/support/reference_table.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::testing {

/// A reference curve: a comma-separated file whose first line names the columns.
class ReferenceCurve {
public:
  /// A file of $TREMOLO_REFERENCE/materials; empty where there is none.
  explicit ReferenceCurve(const std::string& file) : file_(reference_folder() / "materials" / file) {
    std::ifstream stream(file_);
    std::string line;
    std::getline(stream, line);
    std::istringstream cells(line);
    for (std::string name; std::getline(cells, name, ',');) {
      names_.push_back(name);
    }
    rows_ = read_table(file_);
  }

  bool empty() const { return rows_.empty(); }
  std::size_t size() const { return rows_.size(); }

  /// The values of a column.
  /// @throws std::invalid_argument if there is no column of this name
  std::vector<double> column(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) {
      throw std::invalid_argument(file_.string() + " has no column " + name);
    }
    const auto k = static_cast<std::size_t>(found - names_.begin());
    std::vector<double> values;
    values.reserve(rows_.size());
    for (const std::vector<double>& row : rows_) {
      values.push_back(row.at(k));
    }
    return values;
  }

private:
  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> rows_;
};

} // namespace tremolo::testing
