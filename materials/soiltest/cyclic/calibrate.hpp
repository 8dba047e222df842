#pragma once

// One parameter of a law for a wanted cyclic strength: Brent's method (GSL) on
//
//     f(ln x) = ln N(x) - ln N_wanted,
//
// N(x) the cycles to the criterion in a soil test at the wanted stress ratio. For h_po of PM4Sand N grows
// with it.

#include "materials/soiltest/cyclic/cyclic_strength.hpp"

#include <functional>

namespace tremolo::soiltest {

/// A law whose parameter has the given value.
using LawOf = std::function<materials::Law(double parameter)>;

/// Target of a calibration.
struct StrengthTarget {
  double stress_ratio = 0.0;
  double cycles = 15.0;
  Criterion criterion = Criterion::strain_3pc;
};

/// Search range of the parameter.
struct ParameterRange {
  double guess = 0.0;
  double least = 0.0;
  double most = 0.0;
};

/// Result of a calibration.
struct Calibration {
  double parameter = 0.0;
  double cycles = 0.0;         ///< achieved at the wanted stress ratio
  double strength = 0.0;       ///< CSR that reaches the criterion in the wanted number of cycles
  double strength_error = 0.0; ///< strength / wanted - 1
  int tests = 0;               ///< of the search and of the strength
  std::size_t updates = 0;
  double cpu_seconds = 0.0;
};

/// @param test  kind, drainage, initial state, increment; its loading is replaced by stress cycles
/// @throws std::runtime_error if no parameter in the range gives the strength, naming the cycles at both ends
Calibration calibrate(const LawOf& law, const SoilTest& test, const StrengthTarget& target,
                      const ParameterRange& range);

} // namespace tremolo::soiltest
