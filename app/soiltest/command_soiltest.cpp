// tremolo soiltest: element tests of one soil, as a laboratory knows them.

#include "app/commands.hpp"
#include "app/python.hpp"
#include "app/soiltest/soiltest_output.hpp"
#include "app/soiltest/soiltest_progress.hpp"
#include "app/soiltest/soiltest_report.hpp"
#include "scene/soil_test.hpp"
#include "scene/soils/plausible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace tremolo::app {
namespace {

struct Options {
  std::string test;
  std::string out;
  bool plot = false;
  bool library = false;
};

/// Names the likely cause where a law cannot follow a test: a stress in another unit.
std::string stress_doubt(const scene::SoilTestFile& file) {
  const auto doubt = scene::unit_doubt("test.vertical_stress", file.test.initial.vertical_stress);
  return doubt ? "; " + *doubt : "";
}

/// A static bias that the soil cannot carry shows only when it is applied: it is reported at its place.
SoilTestRun run_at_place(const scene::SoilTestFile& file) {
  try {
    return run(file);
  } catch (const std::invalid_argument& error) {
    const auto bias = std::ranges::find(file.values, "test.shear_bias", &scene::ValueInForce::key);
    const bool given = bias != file.values.end() && bias->origin != "default";
    throw std::runtime_error(
        fmt::format("{}: [test] {}", given ? bias->origin : file.file.string() + ":1:1", error.what()));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(error.what() + stress_doubt(file));
  }
}

void test_soil(const Options& options) {
  auto file = scene::load_soil_test(options.test, scene::SoilTestUse::test);
  if (!options.out.empty())
    check_output(options.out, file, options.plot);
  if (options.plot && std::filesystem::path(options.out).extension() != ".h5")
    throw std::runtime_error("--plot draws from an HDF5 file: give --out a name that ends with .h5");
  fmt::print("{}", soil_text(file));
  file.test.watch = soiltest_progress();
  const auto tests = run_at_place(file);
  fmt::print("{}", results_text(file, tests));
  if (!options.out.empty())
    write_soiltest(options.out, file, tests);
  if (options.plot && run_python("soiltest", {options.out}) != 0)
    throw Exit{1};
  for (const Specimen& specimen : tests.specimens)
    if (specimen.result.end == soiltest::End::refused)
      throw std::runtime_error(fmt::format("{}: {} ended early: {}{}", options.test, label(file, specimen),
                                           specimen.result.end_reason, stress_doubt(file)));
}

} // namespace

void add_soiltest(Command& app) {
  auto* command = app.add_subcommand(
      "soiltest",
      "Element tests of a soil: simple shear, triaxial, oedometer; cyclic strength; modulus and damping");
  const auto options = std::make_shared<Options>();
  auto* test = command->add_option("TEST", options->test, "Soil test file, see docs/soil-test-file.md");
  command->add_option("--out", options->out,
                      "Written: .h5 with histories, curves, lines and parameters, or .csv with the history");
  command->add_flag("--plot", options->plot, "Draw OUT.png beside the HDF5 file");
  command->add_flag("--library", options->library, "List the library of soils")->excludes(test);
  command->callback([options] {
    if (options->library)
      fmt::print("{}", library_text());
    else if (options->test.empty())
      throw_required("TEST or --library");
    else
      test_soil(*options);
  });
}

} // namespace tremolo::app
