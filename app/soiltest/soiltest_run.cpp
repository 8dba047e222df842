#include "app/soiltest/soiltest_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>
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

SoilTestRun modulus_curve(const scene::SoilTestFile& file) {
  auto curve = soiltest::modulus_curve(file.soil.law, file.test, file.amplitudes, file.cycles);
  SoilTestRun run;
  for (std::size_t i = 0; i < curve.tests.size(); ++i)
    run.specimens.push_back({none, curve.points[i].amplitude, std::move(curve.tests[i])});
  run.curve = std::move(curve.points);
  return run;
}

} // namespace

SoilTestRun run(const scene::SoilTestFile& file) {
  if (file.kind == scene::LoadingKind::cyclic_stress)
    return {by_stress_ratio(file), {}};
  if (file.kind == scene::LoadingKind::modulus_curve)
    return modulus_curve(file);
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
