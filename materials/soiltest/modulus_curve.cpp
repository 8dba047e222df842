#include "materials/soiltest/modulus_curve.hpp"

#include "materials/parameter_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

Result run_to_end(const materials::Law& law, const SoilTest& test) {
  Result result = run(law, test);
  if (result.end == End::refused) {
    throw std::runtime_error(fmt::format("modulus curve: {}", result.end_reason));
  }
  return result;
}

/// Secant modulus of the first loading, Pa.
double smallest_strain_modulus(const materials::Law& law, SoilTest test) {
  constexpr double small = 1e-7;
  test.loading = Monotonic{small};
  test.strain_increment = small;
  const Result result = run_to_end(law, test);
  const auto tau = [&](std::size_t row) {
    return test.kind == Kind::direct_simple_shear
               ? result.history.column("sig_xy")[row]
               : 0.5 * (result.history.column("sig_xx")[row] - result.history.column("sig_yy")[row]);
  };
  return std::abs(tau(result.history.rows() - 1) - tau(0)) / small;
}

} // namespace

std::vector<ModulusPoint> modulus_curve(const materials::Law& law, const SoilTest& test,
                                        std::span<const double> amplitudes, int cycles, int increments) {
  materials::check_range("increments of a quarter cycle", increments, 1, 1e6);
  const double largest_modulus = smallest_strain_modulus(law, test);
  std::vector<ModulusPoint> curve;
  for (const double amplitude : amplitudes) {
    SoilTest one = test;
    one.loading = StrainCycles{{amplitude}, cycles};
    one.strain_increment = std::min(test.strain_increment, amplitude / increments);
    one.every = std::numeric_limits<std::size_t>::max(); // no history but the reversals
    const Loop last = run_to_end(law, one).loops.back();
    curve.push_back(
        {amplitude, last.modulus, last.modulus / largest_modulus, last.damping, last.pore_pressure_ratio});
  }
  return curve;
}

} // namespace tremolo::soiltest
