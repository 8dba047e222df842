#include "app/commands.hpp"
#include "app/free_field/motion_levels.hpp"

#include "scene/plan/plan.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace tremolo::app {

void add_check(Command& app) {
  auto* command =
      app.add_subcommand("check", "Check a case file and report everything that is wrong with it");
  const auto file = std::make_shared<std::string>();
  command->add_option("CASE", *file, "Case file")->required();
  command->callback([file] {
    const auto scene = scene::load(*file);
    const auto plan = scene::plan(scene);
    fmt::print("{}: ok, {} particles, {} steps of {:.3g} s, processes: domain", *file, plan.particles,
               plan.steps, plan.dt);
    for (const auto& source : plan.sources)
      fmt::print(", {}", source.name);
    fmt::print("\n  {}{}", motion_levels_text(scene), scene::remarks_text(scene));
  });
}

} // namespace tremolo::app
