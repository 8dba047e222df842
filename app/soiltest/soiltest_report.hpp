#pragma once

#include "app/soiltest/soiltest_run.hpp"

#include <string>

namespace tremolo::app {

/// The soil of a test and every parameter in force.
std::string soil_text(const scene::SoilTestFile& file);

/// Cautions about a test's results, one per line.
std::string notes_text(const scene::SoilTestFile& file);

/// Results of the tests: cycles, pore pressure, strength, reasons for their end, and cost.
std::string results_text(const scene::SoilTestFile& file, const SoilTestRun& run);

/// The library of soils, a line each.
std::string library_text();

} // namespace tremolo::app
