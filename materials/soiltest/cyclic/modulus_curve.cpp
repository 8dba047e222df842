#include "materials/soiltest/cyclic/modulus_curve.hpp"

#include "materials/law/parameter_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

Result run_to_end(const materials::Law& law, const SoilTest& test) {
  Result result = run(law, test);
  if (result.end == End::refused)
    throw std::runtime_error(fmt::format("modulus curve: {}", result.end_reason));
  return result;
}

/// Secant shear modulus of the first loading, Pa.
double smallest_strain_modulus(const materials::Law& law, SoilTest test) {
  constexpr double small = 1e-7;
  test.loading = Monotonic{small};
  test.strain_increment = small;
  const Result result = run_to_end(law, test);
  const auto change = [&](std::string_view name) {
    const std::vector<double>& values = result.history.column(name);
    return values.back() - values.front();
  };
  if (test.kind == Kind::direct_simple_shear)
    return change("sig_xy") / change("gamma_xy");
  return 0.5 * (change("sig_xx") - change("sig_yy")) / (change("eps_xx") - change("eps_yy"));
}

} // namespace

ModulusCurve modulus_curve(const materials::Law& law, const SoilTest& test,
                           std::span<const double> amplitudes, int cycles, int increments) {
  materials::check_range("increments of a quarter cycle", increments, 1, 1e6);
  const double largest_modulus = smallest_strain_modulus(law, test);
  ModulusCurve curve;
  for (const double amplitude : amplitudes) {
    SoilTest one = test;
    one.loading = StrainCycles{{amplitude}, cycles};
    one.strain_increment = std::min(test.strain_increment, amplitude / increments);
    curve.tests.push_back(run_to_end(law, one));
    const Loop& last = curve.tests.back().loops.back();
    curve.points.push_back({amplitude, last.shear_strain, last.modulus, last.modulus / largest_modulus,
                            last.damping, last.pore_pressure_ratio});
  }
  return curve;
}

} // namespace tremolo::soiltest
