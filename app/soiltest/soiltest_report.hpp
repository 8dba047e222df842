#pragma once

#include "app/soiltest/soiltest_run.hpp"

#include <string>

namespace tremolo::app {

/// The soil of a test and every parameter in force.
std::string soil_text(const scene::SoilTestFile& file);

/// What should be known of a test before its results are believed, a line each.
std::string notes_text(const scene::SoilTestFile& file);

/// What the tests gave: cycles, pore pressure, strength, why they ended and what they cost.
std::string results_text(const scene::SoilTestFile& file, const SoilTestRun& run);

/// The library of soils, a line each.
std::string library_text();

} // namespace tremolo::app
