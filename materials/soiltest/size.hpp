#pragma once

#include "materials/soiltest/soil_test.hpp"

namespace tremolo::soiltest {

/// Limits on the size of a test.
inline constexpr double most_increments = 1e8;
inline constexpr double most_rows = 1e7; ///< of the history: about 2 GB

/// Increments of a test; of stress cycles, which are not known before, as many as they can be: all of them
/// between +- largest_strain.
double increments(const SoilTest& test);

/// Refuses a test that takes too many increments or keeps too many rows.
/// @throws std::invalid_argument with their number and what to change
void check_size(const SoilTest& test);

} // namespace tremolo::soiltest
