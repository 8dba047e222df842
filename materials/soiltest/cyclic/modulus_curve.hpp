#pragma once

// G/Gmax and damping against strain, from strain-controlled cycles of growing amplitude: each amplitude on a
// fresh specimen, its last loop counts,
//
//     G = (tau_max - tau_min) / (2 gamma),    D = loop area / (2 pi G gamma^2),
//
// with tau and gamma as at the top of soil_test.hpp.

#include "materials/soiltest/soil_test.hpp"

#include <span>
#include <vector>

namespace tremolo::soiltest {

struct ModulusPoint {
  double amplitude = 0.0;     ///< gamma_xy or eps_a
  double shear_strain = 0.0;  ///< gamma; the amplitude in simple shear
  double modulus = 0.0;       ///< G, secant, Pa
  double modulus_ratio = 0.0; ///< over the secant shear modulus of the first loading to 1e-7
  double damping = 0.0;
  double pore_pressure_ratio = 0.0; ///< at the end
};

struct ModulusCurve {
  std::vector<ModulusPoint> points;
  std::vector<Result> tests; ///< the one behind each point
};

/// @param test     drainage, initial state and kind (simple shear, triaxial or plane strain); its loading is
/// not used
/// @param cycles   at each amplitude
/// @param increments  in a quarter of a cycle, at most test.strain_increment each
/// @throws std::invalid_argument for amplitudes that are not positive
/// @throws std::runtime_error if the law refuses a test
ModulusCurve modulus_curve(const materials::Law& law, const SoilTest& test,
                           std::span<const double> amplitudes, int cycles = 3, int increments = 50);

} // namespace tremolo::soiltest
