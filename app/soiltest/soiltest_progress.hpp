#pragma once

#include "materials/soiltest/soil_test.hpp"

#include <functional>

namespace tremolo::app {

/// Prints how far a soil test has come, to stderr: first after three seconds, then at twice the time of the
/// line before. One for all specimens of a command.
std::function<void(const soiltest::TestProgress&)> soiltest_progress();

} // namespace tremolo::app
