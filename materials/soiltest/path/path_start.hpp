#pragma once

#include "materials/soiltest/soil_test.hpp"

namespace tremolo::soiltest {

/// Compares the stress in the first row of a path with the one from which the specimen starts.
/// @throws std::invalid_argument for a controlled stress that is off by more than 1 % of the vertical stress,
/// and for any that is off by a factor of about 1000
void check_start(const Path& path, const InitialState& initial, const materials::PointStress& start);

} // namespace tremolo::soiltest
