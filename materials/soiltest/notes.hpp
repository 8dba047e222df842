#pragma once

#include "materials/soiltest/soil_test.hpp"

#include <string>
#include <vector>

namespace tremolo::soiltest {

/// Whether r_u of a test means something: not that of a total-stress law whose pore water is held back.
bool has_pore_pressure_ratio(const materials::Law& law, const SoilTest& test);

/// Notes on a test that can be run, a sentence each: units that look wrong, an initial stress that the law,
/// or any sand, cannot hold, results without a meaning.
std::vector<std::string> notes(const materials::Law& law, const SoilTest& test);

} // namespace tremolo::soiltest
