#include "app/case/seepage_text.hpp"
#include "app/commands.hpp"
#include "app/free_field/column/column_ground.hpp"
#include "app/free_field/motion_levels.hpp"
#include "app/run/hosts/domain_ranks.hpp"

#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/resolved.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/random/random_text.hpp"

#include <fmt/format.h>

#include <exception>
#include <memory>
#include <string>

namespace tremolo::app {

namespace {

std::string ranks_section(const scene::Case& scene, const DomainRanks& ranks) {
  try {
    check_ranks(scene, ranks, false);
    return fmt::format("\nRanks\n  the domain can run {}\n", ranks_text(scene, ranks, false));
  } catch (const std::exception& not_here) {
    return fmt::format("\nRanks\n  they cannot be started here: {}\n", not_here.what());
  }
}

void print_values(const scene::Case& scene) {
  for (const auto& [key, value, origin] : scene.values)
    fmt::print("{} = {}  # {}\n", key, value, origin);
}

void explain_column(const std::string& file, const std::string& model, bool values) {
  const ColumnGround ground = column_ground(file, scene::computed_model(model));
  const scene::Case& scene = ground.scene;
  const std::string started = start_column(ground);
  const wavefield::TimeGrid times = column_times(ground);
  fmt::print("{}: for `tremolo column --model {}`\n\nGround\n{}\nColumn\n  model {}, {}\n  histories from "
             "{:.4g} to {:.4g} s, every {:.3g} s\n  {}",
             file, model, layers_text(ground), model, started, times.start,
             times.start + times.dt * static_cast<double>(times.count - 1), times.dt,
             motion_levels_text(scene));
  for (const std::string& note : scene::linearised_soils(scene, ground.source))
    fmt::print("  {}\n", note);
  if (scene.random_profile)
    fmt::print("\n{}", scene::random_profile_text(scene));
  if (scene.water)
    fmt::print("\n{}", scene::water_text(scene));
  fmt::print("{}", scene::remarks_text(scene));
  if (values)
    print_values(scene);
}

} // namespace

void add_explain(Command& app) {
  auto* command = app.add_subcommand("explain", "Print the plan of a case: effects, processes, size, cost");
  const auto file = std::make_shared<std::string>();
  const auto values = std::make_shared<bool>(false);
  command->add_option("CASE", *file, "Case file")->required();
  command->add_flag("--values", *values, "Also every value in force and where it came from");
  const auto json = std::make_shared<bool>(false);
  auto* as_json = command->add_flag(
      "--json", *json,
      "The resolved case as JSON instead: values in force, the plan, and the levels and times that "
      "each source serves");
  const auto ranks = std::make_shared<DomainRanks>();
  auto* with_ranks =
      command
          ->add_option("--ranks", ranks->count,
                       "Also where so many processes that share the domain run")
          ->between(2, most_ranks);
  const auto column = std::make_shared<std::string>();
  auto* for_column =
      command
          ->add_option("--column", *column,
                       "The file is for `tremolo column` with this model, and needs the tables of that alone")
          ->one_of(scene::names_of_computed_models());
  for_column->excludes(as_json);
  for_column->excludes(with_ranks);
  command->callback([file, values, json, ranks, column] {
    if (!column->empty())
      return explain_column(*file, *column, *values);
    const auto scene = scene::load(*file);
    const auto plan = scene::plan(scene);
    start_free_fields(scene, plan);
    if (*json) {
      fmt::print("{}\n", scene::resolved_json(scene, plan));
      return;
    }
    fmt::print("{}  {}{}", scene::explain(scene, plan), motion_levels_text(scene), seepage_text(scene));
    if (ranks->count > 1)
      fmt::print("{}", ranks_section(scene, *ranks));
    if (*values)
      print_values(scene);
  });
}

} // namespace tremolo::app
