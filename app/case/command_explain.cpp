#include "app/commands.hpp"

#include "scene/plan/plan.hpp"

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
  command->callback([file, values] {
    const auto scene = scene::load(*file);
    const auto plan = scene::plan(scene);
    fmt::print("{}", scene::explain(scene, plan));
    if (*values)
      for (const auto& [key, value, origin] : scene.values)
        fmt::print("{} = {}  # {}\n", key, value, origin);
  });
}

} // namespace tremolo::app
