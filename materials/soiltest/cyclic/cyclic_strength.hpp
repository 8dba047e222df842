#pragma once

// Cyclic strength: the stress ratio CSR that takes a soil to a criterion in N uniform cycles.
//
// Target of Idriss & Boulanger (2008), Soil liquefaction during earthquakes, EERI MNO-12, for clean sand at
// 1 atm and magnitude 7.5, i.e. 15 cycles:
//
//     CRR = exp(N/14.1 + (N/126)^2 - (N/23.6)^3 + (N/25.4)^4 - 2.8),    N = (N1)60cs = 46 D_R^2
//
// and at other numbers of cycles CSR(n) = CRR (15/n)^b with b = 0.34, the exponent with which they scale
// clean sand with magnitude.

#include "materials/soiltest/soil_test.hpp"

#include <cstddef>

namespace tremolo::soiltest {

/// b of clean sand
inline constexpr double sand_exponent = 0.34;

/// Stress ratios outside of these are not looked at.
inline constexpr double least_stress_ratio = 0.01;
inline constexpr double largest_stress_ratio = 3.0;

/// Failure criteria of a cyclic test.
enum class Criterion { strain_1pc, strain_3pc, strain_5pc, double_amplitude_5pc, ru_98 };
constexpr auto words(Criterion) {
  return word_table<Criterion>({{Criterion::strain_1pc, "strain_1pc"},
                                {Criterion::strain_3pc, "strain_3pc"},
                                {Criterion::strain_5pc, "strain_5pc"},
                                {Criterion::double_amplitude_5pc, "double_amplitude_5pc"},
                                {Criterion::ru_98, "ru_98"}});
}

/// Cycles to the criterion; NaN if it was not reached.
double cycles(const CyclesTo& reached, Criterion criterion);

/// Cycles to the criterion in one test that ends there, and what it cost.
struct FailureTest {
  double cycles = 0.0; ///< most_cycles if it was not reached by then
  std::size_t updates = 0;
  double cpu_seconds = 0.0;
};

/// @param test  kind, drainage, initial state, increment; its loading is not used
/// @throws std::runtime_error if the test ends in another way before, e.g. the law refuses to go on
FailureTest cycles_to_failure(const materials::Law& law, const SoilTest& test, double stress_ratio,
                              double most_cycles, Criterion criterion);

/// A stress ratio that was looked for.
struct CyclicStrength {
  double stress_ratio = 0.0;
  double cycles = 0.0; ///< those of the test at that stress ratio; they change in jumps of up to half a cycle
  int tests = 0;
  std::size_t updates = 0;
  double cpu_seconds = 0.0;
};

/// The stress ratio that reaches the criterion in a number of cycles (CRR15 for 15), by Brent's method on the
/// logarithms, to 0.1 %. The stress ratio of `test` is the first guess.
/// @throws std::invalid_argument for a test without stress cycles
/// @throws std::runtime_error if no stress ratio between 0.01 and 3 does
CyclicStrength cyclic_strength(const materials::Law& law, const SoilTest& test, double cycles = 15.0,
                               Criterion criterion = Criterion::strain_3pc);

/// (N1)60cs = 46 D_R^2; D_R a fraction
double blow_count(double relative_density);
/// CRR at 15 cycles
double idriss_boulanger_strength(double blow_count);
/// CSR at a number of cycles
double idriss_boulanger_strength(double blow_count, double cycles);

} // namespace tremolo::soiltest
