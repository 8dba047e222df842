#pragma once

#include "mpm_domain/spec/output_columns.hpp"
#include "results/run_file.hpp"

#include <span>
#include <string>

namespace tremolo::mpm_domain {

/// Adds a history with the columns of a table to the results.
inline results::TimeSeries& add_history(results::RunWriter& writer, const std::string& path,
                                        std::span<const OutputColumn> table,
                                        std::span<const results::Attribute> attributes = {}) {
  std::vector<std::string> columns;
  std::vector<std::string> units;
  for (const auto& [name, unit] : table) {
    columns.emplace_back(name);
    units.emplace_back(unit);
  }
  return writer.add_series(path, columns, units, attributes);
}

} // namespace tremolo::mpm_domain
