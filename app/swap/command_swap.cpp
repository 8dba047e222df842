// tremolo swap: one case, several free-field models, and what the choice changes.

#include "app/commands.hpp"
#include "app/output_place.hpp"
#include "app/python.hpp"
#include "app/run/local_options.hpp"
#include "app/swap/swap.hpp"
#include "base/text/text_file.hpp"
#include "scene/plan/free_field_traits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct Options {
  std::string case_file;
  std::vector<std::string> models;
  fs::path out;
  int threads = machine_threads();
};

void compare(const Options& options) {
  const auto scene = scene::load(options.case_file);
  if (scene.monitors.empty())
    throw std::runtime_error(
        fmt::format("{}: without a [[monitor]] there is no response to compare", options.case_file));
  const auto models = scene::computed_models(options.models);
  make_folder(options.out);
  if (!fs::is_empty(options.out))
    throw std::runtime_error(
        fmt::format("{} is not an empty folder; choose another --out", options.out.string()));
  const auto runs = swap_models(scene, models, options.out, options.threads);
  write_text_file(options.out / "swap.json", swap_json(runs) + "\n");
  fmt::print("\n");
  if (run_python("swap", {options.out.string()}) != 0 || std::ranges::any_of(runs, &SwappedRun::failed))
    throw Exit{1};
}

} // namespace

void add_swap(Command& app) {
  auto* command = app.add_subcommand(
      "swap", "Run a case with several free-field models and show what the choice changes");
  const auto options = std::make_shared<Options>();
  command->add_option("CASE", options->case_file, "Case file with a [[monitor]] at least")->required();
  command
      ->add_option("--models", options->models,
                   "Models for both sides and the base, separated by commas; the first is the reference")
      ->required()
      ->delimiter(',')
      ->one_of(scene::names_of_computed_models());
  command->add_option("--out", options->out, "New folder: one run a model, swap.json and swap.png")
      ->required();
  command->add_option("--threads", options->threads, "Threads of the domain")
      ->between(1, most_threads)
      ->capture_default_str();
  command->callback([options] { compare(*options); });
}

} // namespace tremolo::app
