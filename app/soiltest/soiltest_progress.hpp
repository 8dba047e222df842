#pragma once

#include "materials/soiltest/soil_test.hpp"

#include <functional>

namespace tremolo::app {

/// Prints the progress of a soil test to stderr, first after three seconds, then each time after twice the
/// previous time. One object serves all specimens of a command.
std::function<void(const soiltest::TestProgress&)> soiltest_progress();

} // namespace tremolo::app
