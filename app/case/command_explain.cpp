#include "app/commands.hpp"
#include "app/free_field/motion_levels.hpp"

#include "scene/plan/plan.hpp"
#include "scene/plan/resolved.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace tremolo::app {

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
  command->callback([file, values, json] {
    const auto scene = scene::load(*file);
    const auto plan = scene::plan(scene);
    if (*json) {
      fmt::print("{}\n", scene::resolved_json(scene, plan));
      return;
    }
    fmt::print("{}  {}", scene::explain(scene, plan), motion_levels_text(scene));
    if (*values)
      for (const auto& [key, value, origin] : scene.values)
        fmt::print("{} = {}  # {}\n", key, value, origin);
  });
}

} // namespace tremolo::app
