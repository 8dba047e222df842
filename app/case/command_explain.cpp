#include "app/commands.hpp"
#include "app/free_field/motion_levels.hpp"
#include "app/run/hosts/domain_ranks.hpp"

#include "scene/plan/plan.hpp"
#include "scene/plan/resolved.hpp"

#include <fmt/format.h>

#include <exception>
#include <memory>
#include <string>

namespace tremolo::app {

namespace {

std::string told_of_ranks(const scene::Case& scene, const DomainRanks& ranks) {
  const auto reason = what_ranks_cannot_share(scene);
  if (!reason.empty())
    return fmt::format("\nRanks\n  {}\n", reason);
  try {
    check_ranks(scene, ranks, false);
    return fmt::format("\nRanks\n  the domain can run {}\n", ranks_text(scene, ranks, false));
  } catch (const std::exception& not_here) {
    return fmt::format("\nRanks\n  ranks can share the domain, but not be started here: {}\n",
                       not_here.what());
  }
}

} // namespace

void add_explain(Command& app) {
  auto* command = app.add_subcommand("explain", "Print the plan of a case: effects, processes, size, cost");
  const auto file = std::make_shared<std::string>();
  const auto values = std::make_shared<bool>(false);
  command->add_option("CASE", *file, "Case file")->required();
  command->add_flag("--values", *values, "Also every value in force and where it came from");
  const auto json = std::make_shared<bool>(false);
  command->add_flag(
      "--json", *json,
      "The resolved case as JSON instead: values in force, the plan, and the levels and times that "
      "each source serves");
  const auto ranks = std::make_shared<DomainRanks>();
  command
      ->add_option("--ranks", ranks->count,
                   "Also whether so many processes can share the domain, and where they run")
      ->between(2, most_ranks);
  command->callback([file, values, json, ranks] {
    const auto scene = scene::load(*file);
    const auto plan = scene::plan(scene);
    if (*json) {
      fmt::print("{}\n", scene::resolved_json(scene, plan));
      return;
    }
    fmt::print("{}  {}", scene::explain(scene, plan), motion_levels_text(scene));
    if (ranks->count > 1)
      fmt::print("{}", told_of_ranks(scene, *ranks));
    if (*values)
      for (const auto& [key, value, origin] : scene.values)
        fmt::print("{} = {}  # {}\n", key, value, origin);
  });
}

} // namespace tremolo::app
