#pragma once

#include "scene/text/findings.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// A table with a key `name`.
struct NamedResult {
  std::string name; ///< empty where it is missing
  std::string path; ///< "monitor[1]"
};

/// Reports names of an array of tables that cannot be those of files and of groups in HDF5, and names that
/// are taken by an earlier table.
/// @param table  "monitor"
void check_result_names(std::string_view table, const std::vector<NamedResult>& named, Findings& findings);

/// Checks the names of items read from these tables. An item without a path belongs to a kind that no stage
/// removes, so that its index is that of its table.
template <class Item>
void check_result_names(std::string_view table, const std::vector<Item>& items, Findings& findings) {
  std::vector<NamedResult> named;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if constexpr (requires { items[i].path; })
      named.push_back({items[i].name, items[i].path});
    else
      named.push_back({items[i].name, std::string(table) + "[" + std::to_string(i) + "]"});
  }
  check_result_names(table, named, findings);
}

} // namespace tremolo::scene
