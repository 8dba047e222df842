#include "app/soiltest_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace tremolo::app {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<Specimen> by_stress_ratio(const scene::SoilTestFile& file) {
  std::vector<Specimen> specimens;
  for (const double ratio : file.stress_ratios) {
    auto test = file.test;
    std::get<soiltest::StressCycles>(test.loading).stress_ratio = ratio;
    specimens.push_back({ratio, none, soiltest::run(file.soil.law, test)});
  }
  return specimens;
}

/// The loops behind a modulus curve, with increments as fine as it takes them.
std::vector<Specimen> by_amplitude(const scene::SoilTestFile& file) {
  constexpr double increments = 50.0; // in a quarter of a cycle
  std::vector<Specimen> specimens;
  for (const double amplitude : file.amplitudes) {
    auto test = file.test;
    test.loading = soiltest::StrainCycles{{amplitude}, file.cycles};
    test.strain_increment = std::min(test.strain_increment, amplitude / increments);
    specimens.push_back({none, amplitude, soiltest::run(file.soil.law, test)});
  }
  return specimens;
}

} // namespace

SoilTestRun run(const scene::SoilTestFile& file) {
  if (file.kind == scene::LoadingKind::cyclic_stress)
    return {by_stress_ratio(file), {}};
  if (file.kind == scene::LoadingKind::modulus_curve)
    return {by_amplitude(file),
            soiltest::modulus_curve(file.soil.law, file.test, file.amplitudes, file.cycles)};
  return {{{none, none, soiltest::run(file.soil.law, file.test)}}, {}};
}

std::string label(const scene::SoilTestFile& file, const Specimen& specimen) {
  if (std::isfinite(specimen.stress_ratio))
    return fmt::format("CSR {:.4g}", specimen.stress_ratio);
  if (std::isfinite(specimen.amplitude))
    return fmt::format("strain {:.3g}", specimen.amplitude);
  return std::string(scene::name(file.kind));
}

} // namespace tremolo::app
