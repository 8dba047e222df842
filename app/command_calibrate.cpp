// tremolo calibrate: the contraction rate of PM4Sand for a wanted cyclic strength.

#include "app/commands.hpp"
#include "app/soiltest_report.hpp"
#include "materials/soiltest/calibrate.hpp"
#include "scene/soil_test.hpp"

#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

namespace tremolo::app {
namespace {

struct Options {
  std::string test;
  std::string out;
};

soiltest::Calibration fit(const scene::SoilTestFile& file) {
  const auto& sand = std::get<materials::Pm4Sand>(file.soil.law);
  const auto law = [&sand](double contraction_rate) -> materials::Law {
    auto changed = sand;
    changed.h_po = contraction_rate;
    return changed;
  };
  const auto& target = *file.target;
  return soiltest::calibrate(
      law, file.test,
      {.stress_ratio = target.stress_ratio, .cycles = target.cycles, .criterion = target.criterion},
      {.guess = target.guess, .least = target.least, .most = target.most});
}

std::string fit_text(const scene::SoilTestFile& file, const soiltest::Calibration& found) {
  const auto& target = *file.target;
  return fmt::format("\nWanted: {} in {:.4g} cycles at a cyclic stress ratio of {:.4g}{}\n"
                     "Found:  contraction_rate = {:.4g}\n"
                     "  {:.2f} cycles at that stress ratio; {:.4g} cycles at {:.4g} ({:+.2f} %)\n"
                     "  {} tests, {:.3g} updates of the law, {:.3g} s\n",
                     soiltest::name(target.criterion), target.cycles, target.stress_ratio,
                     target.of_curve ? ", of Idriss & Boulanger" : "", found.parameter, found.cycles,
                     target.cycles, found.strength, 100.0 * found.strength_error, found.tests,
                     static_cast<double>(found.updates), found.cpu_seconds);
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

std::string provenance(const scene::SoilTestFile& file, const soiltest::Calibration& found) {
  const auto& target = *file.target;
  return fmt::format(
      "# {}\n# contraction_rate fitted by tremolo calibrate: {} in {:.4g} cycles at a stress ratio of "
      "{:.4g}\n# ({}, {}, vertical stress {:.4g} Pa, K0 {:.3g}); error of the strength {:+.2f} %\n",
      file.title, soiltest::name(target.criterion), target.cycles, target.stress_ratio,
      soiltest::name(file.test.kind), soiltest::name(file.test.drainage), file.test.initial.vertical_stress,
      file.test.initial.k0, 100.0 * found.strength_error);
}

void calibrate(const Options& options) {
  const auto file = scene::load_soil_test(options.test, scene::SoilTestUse::calibration);
  fmt::print("{}", soil_text(file));
  const auto found = fit(file);
  const auto table = soil_table(file, found.parameter);
  fmt::print("{}\n{}", fit_text(file, found), table);
  if (options.out.empty())
    return;
  std::ofstream stream(options.out, std::ios::binary);
  stream << provenance(file, found) << table;
  if (!stream.flush())
    throw std::runtime_error(fmt::format("{}: cannot be written", options.out));
}

} // namespace

void add_calibrate(CLI::App& app) {
  auto* command =
      app.add_subcommand("calibrate", "Fit the contraction rate of PM4Sand to a wanted cyclic strength");
  const auto options = std::make_shared<Options>();
  command->add_option("TEST", options->test, "Soil test file with a [target], see docs/soil-test-file.md")
      ->required();
  command->add_option("--out", options->out, "Written: the soil's table (TOML), with where it comes from");
  command->callback([options] { calibrate(*options); });
}

} // namespace tremolo::app
