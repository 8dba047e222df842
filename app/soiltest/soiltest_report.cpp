#include "app/soiltest/soiltest_report.hpp"

#include "materials/soiltest/notes.hpp"
#include "scene/soils/plausible.hpp"
#include "scene/soils/soil_library.hpp"
#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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
    const std::string ratio = soiltest::has_pore_pressure_ratio(file.soil.law, file.test)
                                  ? fmt::format("{:.3f}", result.largest_pore_pressure_ratio)
                                  : "-";
    text += fmt::format("  {:<16}{:>9}{:>9}{:>9}{:>12}{:>9}   {}\n", label(file, specimen),
                        or_dash(to.strain_1pc), or_dash(to.strain_3pc), or_dash(to.strain_5pc),
                        or_dash(to.ru_98), ratio, result.end_reason);
  }
  return text;
}

std::string modulus_text(const SoilTestRun& run) {
  std::string text =
      fmt::format("\n  {:>12}{:>12}{:>14}{:>10}{:>10}\n", "strain", "gamma", "G (Pa)", "G/Gmax", "damping");
  for (const auto& point : run.curve)
    text += fmt::format("  {:>12.3g}{:>12.3g}{:>14.4g}{:>10.3f}{:>10.4f}\n", point.amplitude,
                        point.shear_strain, point.modulus, point.modulus_ratio, point.damping);
  return text;
}

std::string loops_text(const SoilTestRun& run) {
  std::string text =
      fmt::format("\n  {:>12}{:>8}{:>12}{:>14}{:>10}\n", "strain", "cycle", "gamma", "G (Pa)", "damping");
  for (const soiltest::Loop& loop : run.specimens.front().result.loops)
    text += fmt::format("  {:>12.3g}{:>8}{:>12.3g}{:>14.4g}{:>10.4f}\n", loop.amplitude, loop.cycle,
                        loop.shear_strain, loop.modulus, loop.damping);
  return text;
}

std::string peak_text(const SoilTestRun& run) {
  const auto& result = run.specimens.front().result;
  return fmt::format("\n  peak shear stress {:.4g} Pa, largest strain {:.3g}; {}\n", result.peak_shear_stress,
                     result.largest_strain, result.end_reason);
}

/// Changes over a test, compression positive.
struct Changes {
  double vertical_stress = 0.0; ///< effective, Pa
  double mean_stress = 0.0;     ///< effective, of all three directions, Pa
  double vertical_strain = 0.0;
  double volumetric_strain = 0.0;
};

Changes changes(const soiltest::History& history) {
  const auto change = [&history](const char* name) {
    const bool recorded = history.has(name); // no column of a strain that is zero throughout
    return recorded ? history.column(name).front() - history.column(name).back() : 0.0;
  };
  const double vertical = change("sig_yy");
  return {vertical, (change("sig_xx") + vertical + change("sig_zz")) / 3.0, change("eps_yy"),
          change("eps_xx") + change("eps_yy") + change("eps_zz")};
}

/// The results of a monotonic test.
std::string monotonic_text(const scene::SoilTestFile& file, const SoilTestRun& run) {
  const auto& result = run.specimens.front().result;
  const Changes of = changes(result.history);
  switch (file.test.kind) {
  case soiltest::Kind::oedometer:
    return fmt::format("\n  constrained modulus {:.4g} Pa (secant, effective stress), settlement strain "
                       "{:.3g}; {}\n",
                       of.vertical_stress / of.vertical_strain, of.vertical_strain, result.end_reason);
  case soiltest::Kind::isotropic_compression:
    return fmt::format(
        "\n  bulk modulus {:.4g} Pa (secant, effective stress), volumetric strain {:.3g}; {}\n",
        of.mean_stress / of.volumetric_strain, of.volumetric_strain, result.end_reason);
  case soiltest::Kind::direct_simple_shear:
  case soiltest::Kind::path:
    return peak_text(run);
  default:
    return fmt::format(
        "\n  peak q {:.4g} Pa, mobilised angle {:.2f} deg; at the end volumetric strain {:.3g} "
        "(compression positive); {}\n",
        2.0 * result.peak_shear_stress, result.mobilised_angle * 180.0 / std::numbers::pi,
        of.volumetric_strain, result.end_reason);
  }
}

/// The stress that the apparatus holds, and what it is called.
std::pair<double, const char*> held_stress(const soiltest::SoilTest& test) {
  using enum soiltest::Kind;
  const auto& initial = test.initial;
  if (test.kind == triaxial_compression || test.kind == triaxial_extension)
    return {initial.k0 * initial.vertical_stress, "cell pressure"};
  if (test.kind == plane_strain_compression || test.kind == plane_strain_extension)
    return {initial.k0 * initial.vertical_stress, "lateral stress"};
  return {initial.vertical_stress, "vertical stress"};
}

std::string missing_text(const scene::SoilTestFile& file, const SoilTestRun& run) {
  const auto [held, what] = held_stress(file.test);
  std::string text;
  for (const Specimen& specimen : run.specimens)
    if (const double missing = specimen.result.largest_missing_stress; missing > 1e-4 * held)
      text += fmt::format("\n  {}: the {} was missed by up to {:.3g} kPa ({:.2g} %)\n", label(file, specimen),
                          what, 1e-3 * missing, 100.0 * missing / held);
  return text;
}

std::string leaps_text(const scene::SoilTestFile& file, const SoilTestRun& run) {
  std::string text;
  for (const Specimen& specimen : run.specimens)
    if (const materials::Leaps& leaps = specimen.result.leaps; leaps.count > 0)
      text += fmt::format(
          "\n  note: {}: the law is not unique. {} at gamma = {:.3g} (eps_yy = {:.3g}), no strain near the "
          "last "
          "increments holds the {}; the strain leaps by up to {:.2g} ({:.2g} increments), and {} of {} "
          "increments "
          "lie on another branch\n",
          label(file, specimen), leaps.count == 1 ? "Once," : fmt::format("{} times, first", leaps.count),
          leaps.first.xy, leaps.first.yy, held_stress(file.test).second, leaps.largest,
          leaps.largest / file.test.strain_increment, leaps.steps_away, specimen.result.increments);
  return text;
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
  for (const std::string& note : materials::notes(file.soil.law))
    lines += fmt::format("  - {}\n", note);
  for (const auto& [key, doubt] : scene::unit_doubts(file.values))
    lines += fmt::format("  - {}\n", doubt);
  return lines;
}

std::string notes_text(const scene::SoilTestFile& file) {
  std::string lines;
  for (const std::string& note : soiltest::notes(file.soil.law, file.test))
    lines += fmt::format("  note: {}\n", note);
  return lines;
}

std::string results_text(const scene::SoilTestFile& file, const SoilTestRun& run) {
  const auto& initial = file.test.initial;
  std::string lines =
      fmt::format("\nTest: {}, {}, {}; vertical stress {:.4g} Pa, K0 {:.3g}, shear bias {:.3g}\n",
                  soiltest::name(file.test.kind), soiltest::name(file.test.drainage), scene::name(file.kind),
                  initial.vertical_stress, initial.k0, initial.shear_bias);
  lines += notes_text(file);
  switch (file.kind) {
  case scene::LoadingKind::cyclic_stress:
    lines += cycles_text(file, run);
    break;
  case scene::LoadingKind::cyclic_strain:
    lines += cycles_text(file, run) + loops_text(run);
    break;
  case scene::LoadingKind::modulus_curve:
    lines += modulus_text(run);
    break;
  case scene::LoadingKind::monotonic:
    lines += monotonic_text(file, run);
    break;
  case scene::LoadingKind::path:
    lines += peak_text(run);
    break;
  }
  return lines + missing_text(file, run) + leaps_text(file, run) + cost_text(run);
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
