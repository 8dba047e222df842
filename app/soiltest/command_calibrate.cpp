// tremolo calibrate: the contraction rate of PM4Sand for a wanted cyclic strength.

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "app/soiltest/soiltest_progress.hpp"
#include "app/soiltest/soiltest_report.hpp"
#include "base/text/text_file.hpp"
#include "materials/soiltest/cyclic/calibrate.hpp"
#include "scene/soil_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo::app {
namespace {

struct Options {
  std::string test;
  std::string out;
};

soiltest::Calibration fit(const scene::SoilTestFile& file) {
  const auto law = [&file](double contraction_rate) {
    return materials::with_contraction_rate(file.soil.law, contraction_rate);
  };
  const auto& target = *file.target;
  return soiltest::calibrate(
      law, file.test,
      {.stress_ratio = target.stress_ratio, .cycles = target.cycles, .criterion = target.criterion},
      {.guess = target.guess, .least = target.least, .most = target.most});
}

/// A text on the origin of the wanted stress ratio.
std::string target_text(const scene::SoilTestFile& file) {
  const auto& target = *file.target;
  if (!target.curve)
    return fmt::format("{:.4g}, as given", target.stress_ratio);
  return fmt::format("{:.4g} = {:.4g} at 1 atm x K_sigma {:.4g} at {:.4g} Pa, Idriss & Boulanger (2008)",
                     target.stress_ratio, target.curve->at_one_atmosphere, target.curve->overburden_factor,
                     file.test.initial.vertical_stress);
}

std::string fit_text(const scene::SoilTestFile& file, const soiltest::Calibration& found) {
  const auto& target = *file.target;
  return fmt::format("\nWanted: {} in {:.4g} cycles at a cyclic stress ratio of {}\n"
                     "Found:  contraction_rate = {:.4g}\n"
                     "  {:.2f} cycles at that stress ratio; {:.4g} cycles at {:.4g} ({:+.2f} %)\n"
                     "  {} tests, {:.3g} updates of the law, {:.3g} s\n",
                     soiltest::name(target.criterion), target.cycles, target_text(file), found.parameter,
                     found.cycles, target.cycles, found.strength, 100.0 * found.strength_error, found.tests,
                     static_cast<double>(found.updates), found.cpu_seconds);
}

/// A text on the counting of cycles. With this counting the published contraction rates reach 3 % in 13.7 to
/// 14.2 cycles where 15 are wanted; the fitted rates differ from them accordingly.
constexpr std::string_view counting =
    "Counting: the wanted strain is reached at cycles = N, interpolated within the half cycle; with N = 15.0 "
    "and 3 % the published contraction rates (D_R 0.35, 0.55, 0.75; 13.7 to 14.2 cycles) are met within 10 % "
    "at 0.35 and 0.55, +25 % at 0.75\n";

/// Why no contraction rate gives the wanted strength: what those at both ends give.
std::string out_of_reach(const scene::SoilTestFile& file, const std::string& found) {
  const auto& target = *file.target;
  const auto strength = [&](double contraction_rate) {
    const auto law = materials::with_contraction_rate(file.soil.law, contraction_rate);
    auto test = file.test;
    test.loading = soiltest::StressCycles{.stress_ratio = target.stress_ratio};
    try {
      const auto found_there = soiltest::cyclic_strength(law, test, target.cycles, target.criterion);
      return fmt::format("{:.3g}", found_there.stress_ratio);
    } catch (const std::exception& error) {
      return fmt::format("none ({})", error.what());
    }
  };
  const bool drained = file.test.drainage == soiltest::Drainage::drained;
  return fmt::format(
      "{}: [target] no 'contraction_rate' from {:g} to {:g} gives the cyclic stress ratio {:.4g} "
      "for {} in {:g} cycles{}: at {:g} it is {}, at {:g} {} ({})",
      target.place, target.least, target.most, target.stress_ratio, soiltest::name(target.criterion),
      target.cycles, drained ? "; the test is drained, and drained soil does not liquefy" : "", target.least,
      strength(target.least), target.most, strength(target.most), found);
}

/// The soil's table as the file gives it, with the parameter that was found.
std::string soil_table(const scene::SoilTestFile& file, double contraction_rate) {
  constexpr std::string_view table = "soil.";
  constexpr std::string_view fitted = "contraction_rate";
  std::string text = "[soil.calibrated]\n";
  for (const auto& [key, value, origin] : file.values)
    if (key.starts_with(table) && origin != "default") {
      const auto name = std::string_view(key).substr(table.size());
      text += name == fitted                   ? fmt::format("{} = {:.4g}\n", name, contraction_rate)
              : origin.starts_with("library ") ? ""
                                               : fmt::format("{} = {}\n", name, value);
    }
  return text;
}

constexpr const char* fitted_by = "# contraction_rate fitted by tremolo calibrate:";

std::string provenance(const scene::SoilTestFile& file, const soiltest::Calibration& found) {
  const auto& target = *file.target;
  return fmt::format(
      "# {}\n{} {} in {:.4g} cycles at a stress ratio of\n"
      "# {}\n# ({}, {}, vertical stress {:.4g} Pa, K0 {:.3g}); error of the strength {:+.2f} %\n",
      file.title, fitted_by, soiltest::name(target.criterion), target.cycles, target_text(file),
      soiltest::name(file.test.kind), soiltest::name(file.test.drainage), file.test.initial.vertical_stress,
      file.test.initial.k0, 100.0 * found.strength_error);
}

void calibrate(const Options& options) {
  auto file = scene::load_soil_test(options.test, scene::SoilTestUse::calibration);
  if (!options.out.empty())
    require_writable(options.out, {options.test}, has_words(fitted_by));
  fmt::print("{}{}", soil_text(file), notes_text(file));
  if (std::ranges::any_of(file.values, [](const auto& value) { return value.key.starts_with("loading."); }))
    fmt::print("  note: [loading] is for `tremolo soiltest`; a calibration applies the cycles of [target]\n");
  file.test.watch = soiltest_progress();
  soiltest::Calibration found;
  try {
    found = fit(file);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(out_of_reach(file, error.what()));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(fmt::format("{}: [target] {}", file.target->place, error.what()));
  }
  const auto table = soil_table(file, found.parameter);
  fmt::print("{}{}\n{}", fit_text(file, found), counting, table);
  if (!options.out.empty())
    write_text_file(options.out, provenance(file, found) + table);
}

} // namespace

void add_calibrate(Command& app) {
  auto* command =
      app.add_subcommand("calibrate", "Fit the contraction rate of PM4Sand to a wanted cyclic strength");
  const auto options = std::make_shared<Options>();
  command->add_option("TEST", options->test, "Soil test file with a [target], see docs/soil-test-file.md")
      ->required();
  command->add_option("--out", options->out, "Written: the soil's table (TOML), with where it comes from");
  command->callback([options] { calibrate(*options); });
}

} // namespace tremolo::app
