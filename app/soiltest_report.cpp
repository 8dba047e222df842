#include "app/soiltest_report.hpp"

#include "scene/soil_library.hpp"
#include "scene/soil_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::app {
namespace {

std::string or_dash(double cycles) {
  return std::isfinite(cycles) ? fmt::format("{:.2f}", cycles) : "-";
}

std::string cycles_text(const scene::SoilTestFile& file, const SoilTestRun& run) {
  std::string text = fmt::format("\n  {:<16}{:>9}{:>9}{:>9}{:>12}{:>9}   ended because\n", "cycles to", "1 %",
                                 "3 %", "5 %", "r_u = 0.98", "max r_u");
  for (const Specimen& specimen : run.specimens) {
    const auto& result = specimen.result;
    const auto& to = result.cycles_to;
    text += fmt::format("  {:<16}{:>9}{:>9}{:>9}{:>12}{:>9.3f}   {}\n", label(file, specimen),
                        or_dash(to.strain_1pc), or_dash(to.strain_3pc), or_dash(to.strain_5pc),
                        or_dash(to.ru_98), result.largest_pore_pressure_ratio, result.end_reason);
  }
  return text;
}

std::string modulus_text(const SoilTestRun& run) {
  std::string text = fmt::format("\n  {:>12}{:>14}{:>10}{:>10}\n", "strain", "G (Pa)", "G/Gmax", "damping");
  for (const auto& point : run.curve)
    text += fmt::format("  {:>12.3g}{:>14.4g}{:>10.3f}{:>10.4f}\n", point.amplitude, point.modulus,
                        point.modulus_ratio, point.damping);
  return text;
}

std::string peak_text(const SoilTestRun& run) {
  const auto& result = run.specimens.front().result;
  return fmt::format("\n  peak shear stress {:.4g} Pa, largest strain {:.3g}; {}\n", result.peak_shear_stress,
                     result.largest_strain, result.end_reason);
}

std::string cost_text(const SoilTestRun& run) {
  double updates = 0.0;
  double seconds = 0.0;
  for (const Specimen& specimen : run.specimens) {
    updates += static_cast<double>(specimen.result.updates);
    seconds += specimen.result.cpu_seconds;
  }
  return fmt::format("\n  {:.3g} updates of the law in {:.3g} s, {:.3g} us each\n", updates, seconds,
                     1e6 * seconds / std::max(updates, 1.0));
}

} // namespace

std::string soil_text(const scene::SoilTestFile& file) {
  std::string lines =
      fmt::format("{}\n\nSoil: {}{}\n", file.title, scene::model_in_force("soil", file.values),
                  file.library.empty() ? "" : ", library " + file.library);
  lines += scene::text(scene::parameters_in_force(file.soil, "soil", file.values));
  for (const std::string& note : scene::notes(file.soil))
    lines += fmt::format("  - {}\n", note);
  return lines;
}

std::string results_text(const scene::SoilTestFile& file, const SoilTestRun& run) {
  const auto& initial = file.test.initial;
  std::string lines =
      fmt::format("\nTest: {}, {}, {}; vertical stress {:.4g} Pa, K0 {:.3g}, shear bias {:.3g}\n",
                  soiltest::name(file.test.kind), soiltest::name(file.test.drainage), scene::name(file.kind),
                  initial.vertical_stress, initial.k0, initial.shear_bias);
  switch (file.kind) {
  case scene::LoadingKind::cyclic_stress:
  case scene::LoadingKind::cyclic_strain:
    lines += cycles_text(file, run);
    break;
  case scene::LoadingKind::modulus_curve:
    lines += modulus_text(run);
    break;
  case scene::LoadingKind::monotonic:
  case scene::LoadingKind::path:
    lines += peak_text(run);
    break;
  }
  return lines + cost_text(run);
}

std::string library_text() {
  std::size_t width = 0;
  for (const auto& soil : scene::soil_library())
    width = std::max(width, soil.name.size());
  std::string lines;
  for (const auto& soil : scene::soil_library())
    lines += fmt::format("{:<{}}  {:<16}  {}\n", soil.name, width,
                         (*soil.keys)["model"].value_or(std::string_view{}), soil.title);
  return lines;
}

} // namespace tremolo::app
