// tremolo resume: continues a run that has ended early from its newest checkpoint.

#include "app/commands.hpp"
#include "app/run/case_run.hpp"
#include "app/run/earlier_results.hpp"
#include "app/run/local_options.hpp"
#include "app/run/run_display.hpp"
#include "app/run/until_stage.hpp"
#include "base/text/printable.hpp"
#include "scene/case.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

struct ResumeArguments {
  fs::path folder;
  std::string until;
  LocalOptions local;
};

void resume(const ResumeArguments& arguments) {
  const fs::path& folder = arguments.folder;
  const fs::path case_file = folder / "case.toml";
  if (!fs::exists(case_file))
    throw std::runtime_error(fmt::format("{} is no folder of a run: it has no case.toml", folder.string()));
  const auto [set, damaged] = coupler::find_sets(folder / "checkpoints");
  if (earlier_results_are_complete(folder, set))
    throw std::runtime_error(
        fmt::format("the run in {} is complete: there is nothing to go on with", folder.string()));
  for (const auto& what : damaged)
    fmt::print(stderr, "tremolo: warning: {}\n", printable(what));
  if (!set)
    throw std::runtime_error(fmt::format(
        "the run in {} has no complete checkpoint; they are made as [checkpoint] of the case says. "
        "To begin again: tremolo run {}",
        folder.string(), case_file.string()));
  const auto scene = scene::load(case_file);
  const std::string mode(coupler::name(set->run.mode)); // the command line may have chosen it
  check_ranks(scene, arguments.local.ranks, arguments.local.local);
  coupler::require_same_run(*set, identity_of(scene, mode));
  check_until(scene, arguments.until, *set);
  fmt::print("going on from step {}, {:.6g} s\n", set->step, set->time);
  const auto summaries = run_case(scene, {.folder = folder,
                                          .mode = mode,
                                          .transport = arguments.local.transport,
                                          .threads = arguments.local.threads_of_domain(scene),
                                          .keys = arguments.local.keys,
                                          .local = arguments.local.local,
                                          .ranks = arguments.local.ranks,
                                          .until = arguments.until,
                                          .resume = set});
  fmt::print("{}results: {}\n", summary_text(summaries), (folder / "run.h5").string());
}

} // namespace

void add_resume(Command& app) {
  auto* command = app.add_subcommand(
      "resume", "Go on with a run that has ended early, from its newest checkpoint: the results are the same "
                "bits as those of an unbroken run");
  const auto arguments = std::make_shared<ResumeArguments>();
  command->add_option("RUN", arguments->folder, "Folder of the run")->required()->existing_folder();
  add_until_option(*command, arguments->until);
  add_local_options(*command, arguments->local);
  command->callback([arguments] { resume(*arguments); });
}

} // namespace tremolo::app
