#pragma once

#include "materials/soiltest/soil_test.hpp"

#include <array>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::soiltest {

/// Names of the columns of stress, xx, yy, xy, zz.
inline constexpr std::array<std::string_view, 4> stress_names = {"sig_xx", "sig_yy", "sig_xy", "sig_zz"};

/// Position of a row, for messages: "row 4 of the path (line 5)", without the line if it has no table.
std::string place(const PathRow& row, std::size_t index);

/// Reads a path from comma-separated columns named in the first line: step, eps_xx, eps_yy, gamma_xy (and
/// eps_zz), of which `by_stress` names those that are controlled by the stresses sig_xx, sig_yy, sig_xy,
/// sig_zz instead. Without a column step every row is one increment; other columns are passed over, so that a
/// history can be replayed, but for stresses in the first row, which check_start() compares.
/// @param by_stress    e.g. { "sig_yy" }
/// @param stress_unit  Pa in one unit of the stress columns: 1 for Pa, 1000 for kPa
/// @throws std::invalid_argument naming the line and what is wrong with it
Path read_path(std::istream& table, const std::vector<std::string>& by_stress = {}, double stress_unit = 1.0);

} // namespace tremolo::soiltest
