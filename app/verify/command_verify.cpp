// tremolo verify: the particle velocities of a run against the exact field.

#include "app/commands.hpp"
#include "app/python.hpp"
#include "app/verify/verification_report.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace tremolo::app {
namespace {

namespace fs = std::filesystem;

constexpr int above_tolerance = 1;

fs::path run_file(const fs::path& run) {
  return fs::is_directory(run) ? run / "run.h5" : run;
}

void verify_run(const fs::path& run) {
  const fs::path file = run_file(run);
  require_report_writable(file);
  const results::RunReader reader(file);
  const scene::Case scene = scene::parse(reader.case_text(), file / "case", file.parent_path());
  const auto verification = [&] {
    try {
      return verify(reader, scene);
    } catch (const std::runtime_error& error) {
      std::fprintf(stderr, "tremolo: %s: cannot be verified: %s\n", file.c_str(), error.what());
      throw Exit{refused};
    }
  }();
  fmt::print("{}", text(verification, scene));
  write_report(verification, scene, file);
  const fs::path json = file.parent_path() / "verify.json";
  fmt::print("{}\n{}\n", json.string(), (file.parent_path() / "verify.h5").string());
  if (run_python("verify-picture", {json.string()}) != 0)
    throw std::runtime_error("the picture of the verification could not be made, see above");
  if (!passed(verification, scene))
    throw Exit{above_tolerance};
}

} // namespace

void add_verify(Command& app) {
  auto* command = app.add_subcommand(
      "verify",
      "Compare a run on level, uniform, elastic ground with the exact field: numbers and a picture");
  const auto run = std::make_shared<std::string>();
  command->add_option("RUN", *run, "Folder of the run, or its run.h5")->required();
  command->footer(
      "Ends with 0 where the relative L2 error of particle velocity is within [verify] tolerance, "
      "with 1 above it, and with 2 where the exact field of the case is not known.");
  command->callback([run] { verify_run(*run); });
}

} // namespace tremolo::app
