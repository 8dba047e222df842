#include "app/commands.hpp"
#include "app/free_field/column/column_ground.hpp"
#include "app/free_field/motion_levels.hpp"

#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/plan.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace tremolo::app {

namespace {

void check_case(const std::string& file) {
  const auto scene = scene::load(file);
  const auto plan = scene::plan(scene);
  start_free_fields(scene, plan);
  fmt::print("{}: ok, {} particles, {} steps of {:.3g} s, processes: domain", file, plan.particles,
             plan.steps, plan.dt);
  for (const auto& source : plan.sources)
    fmt::print(", {}", source.name);
  fmt::print("\n  {}{}", motion_levels_text(scene), scene::remarks_text(scene));
}

void check_column(const std::string& file, const std::string& model) {
  const ColumnGround ground = column_ground(file, scene::computed_model(model));
  fmt::print("{}: ok for `tremolo column --model {}`, {}\n", file, model, start_column(ground));
  fmt::print("  {}{}", motion_levels_text(ground.scene), scene::remarks_text(ground.scene));
}

} // namespace

void add_check(Command& app) {
  auto* command =
      app.add_subcommand("check", "Check a case file and report everything that is wrong with it");
  const auto file = std::make_shared<std::string>();
  const auto column = std::make_shared<std::string>();
  command->add_option("CASE", *file, "Case file")->required();
  command
      ->add_option("--column", *column,
                   "The file is for `tremolo column` with this model, and needs the tables of that alone")
      ->one_of(scene::names_of_computed_models());
  command->callback([file, column] {
    if (column->empty())
      check_case(*file);
    else
      check_column(*file, *column);
  });
}

} // namespace tremolo::app
