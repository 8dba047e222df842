#pragma once

#include "scene/text/findings.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// Reports names of an array of tables that cannot be those of files and of groups in HDF5, and names that
/// are taken by an earlier table.
/// @param table  of the key `name`, "monitor"
/// @param names  one a table; empty where it is missing
void check_result_names(std::string_view table, const std::vector<std::string>& names, Findings& findings);

} // namespace tremolo::scene
