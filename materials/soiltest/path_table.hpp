#pragma once

#include "materials/soiltest/soil_test.hpp"

#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::soiltest {

/// Reads a path from comma-separated columns named in the first line: step, eps_xx, eps_yy, gamma_xy (and
/// eps_zz), of which `by_stress` names those that are controlled by the stresses sig_xx, sig_yy, sig_xy,
/// sig_zz instead. Without a column step every row is one increment; other columns are passed over, so that a
/// history can be replayed.
/// @param by_stress    e.g. { "sig_yy" }
/// @param stress_unit  Pa in one unit of the stress columns: 1 for Pa, 1000 for kPa
/// @throws std::invalid_argument naming the line and what is wrong with it
Path read_path(std::istream& table, const std::vector<std::string>& by_stress = {}, double stress_unit = 1.0);

} // namespace tremolo::soiltest
