#pragma once

#include "materials/soiltest/cyclic/modulus_curve.hpp"
#include "materials/soiltest/soil_test.hpp"
#include "scene/soil_test.hpp"

#include <vector>

namespace tremolo::app {

/// One specimen.
struct Specimen {
  double stress_ratio = 0.0; ///< of stress cycles; NaN otherwise
  double amplitude = 0.0;    ///< of a modulus curve; NaN otherwise
  soiltest::Result result;
};

/// All specimens of a test file.
struct SoilTestRun {
  std::vector<Specimen> specimens;           ///< one a stress ratio, or one an amplitude of a modulus curve
  std::vector<soiltest::ModulusPoint> curve; ///< of modulus curves
};

/// Runs every test of the file.
/// @throws std::runtime_error if the law refuses a modulus curve
SoilTestRun run(const scene::SoilTestFile& file);

/// A test in a few words, "CSR 0.147", "amplitude 0.001", or the kind of loading.
std::string label(const scene::SoilTestFile& file, const Specimen& specimen);

} // namespace tremolo::app
