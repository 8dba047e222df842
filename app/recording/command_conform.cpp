// tremolo conform: whether a program serves a free field as a run needs it
// (coupler/conformance/conformance.hpp).

#include "app/commands.hpp"
#include "app/temporary_folder.hpp"
#include "base/text/printable.hpp"
#include "base/text/text_file.hpp"
#include "coupler/conformance/conformance.hpp"
#include "scene/case.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

/// The case that the program has to serve if none is named.
constexpr std::string_view built_in_case = R"(
title = "conformance: a small box under a vertical SV pulse"

[motion]
pulse = { shape = "ricker", frequency = 3.0, time = 0.7, velocity = 0.1 }
wave = "SV"
angle_deg = 0.0
reference = [0.0, -10.0]

[surface]
level = 0.0

[halfspace]
density = 1700.0
young = 40e6
poisson = 0.28

[soil.box]
model = "linear_elastic"
density = 1700.0
young = 40e6
poisson = 0.28

[[region]]
soil = "box"
polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]

[mesh]
size = 1.0
box = [0.0, -10.0, 20.0, 0.0]

[boundary]
left = { model = "wave" }
right = { model = "wave" }
base = { model = "wave", form = "total" }

[[stage]]
kind = "shaking"
duration_s = 1.5

[output]
every_s = 0.1
history_every_s = 0.01
)";

struct Arguments {
  std::vector<std::string> command;
  fs::path case_file;
  std::string name;
};

fs::path written_built_in_case(const fs::path& folder) {
  fs::path file = folder / "case.toml";
  write_text_file(file, built_in_case);
  return file;
}

coupler::ExchangedFace face(const std::string& source, scene::BaseForm field, double x, double y) {
  return {.position = {x, y}, .source = source, .field = std::string(scene::name(field))};
}

/// The middles of intervals of about this spacing.
std::vector<double> middles(double from, double to, double spacing) {
  const auto count = static_cast<int>(std::max(1.0, std::round((to - from) / spacing)));
  std::vector<double> at;
  at.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    at.push_back(from + (to - from) * (i + 0.5) / count);
  return at;
}

/// Faces half way between the points of the boundary, as those of particles are.
std::vector<coupler::ExchangedFace> faces(const scene::Case& scene, const scene::SourceProcess& source) {
  const scene::Box& box = scene.mesh.box;
  const double spacing = scene.mesh.particle_size();
  std::vector<coupler::ExchangedFace> list;
  for (const scene::Served& served : source.serves) {
    if (served.side == scene::Side::base) {
      for (const double x : middles(box.x_min, box.x_max, spacing))
        list.push_back(face(source.name, served.field, x, box.y_min));
      continue;
    }
    const double x = served.side == scene::Side::left ? box.x_min : box.x_max;
    for (const double y : middles(box.y_min, source.surface, spacing))
      list.push_back(face(source.name, served.field, x, y));
  }
  return list;
}

coupler::Demand demand(const scene::Case& scene, const scene::SourceProcess& source) {
  coupler::Demand demand{.faces = faces(scene, source),
                         .start_time = 0.0,
                         .end_time = scene.end(),
                         .least_density = scene.halfspace.density,
                         .largest_density = scene.halfspace.density};
  for (const scene::Layer& layer : scene::layers(scene, source)) {
    demand.least_density = std::min(demand.least_density, layer.elastic.density);
    demand.largest_density = std::max(demand.largest_density, layer.elastic.density);
  }
  return demand;
}

void conform(const Arguments& arguments) {
  const TemporaryFolder folder;
  const bool built_in = arguments.case_file.empty();
  const fs::path case_file =
      built_in ? written_built_in_case(folder.path()) : fs::absolute(arguments.case_file);
  const scene::Case scene = scene::load(case_file);
  const scene::Plan plan = scene::plan(scene);
  const scene::SourceProcess& source =
      arguments.name.empty() ? plan.sources.front() : scene::source_named(plan, arguments.name);

  coupler::ProbeOptions options{.command = arguments.command,
                                .case_file = case_file,
                                .name = source.name,
                                .folder = folder.path(),
                                .deadlines = {scene.coupling.connect_deadline, scene.coupling.step_deadline,
                                              scene.coupling.shutdown_deadline}};
  options.command.front() = fs::absolute(options.command.front()).string();
  fmt::print("{} as '{}' of {}\n", arguments.command.front(), source.name,
             built_in ? "the built-in case" : case_file.string());
  const auto checks = coupler::conform(options, demand(scene, source));
  for (const coupler::Check& check : checks)
    fmt::print("  {:<4}  {:<22}  {}\n", coupler::name(check.verdict), check.name, printable(check.finding));
  const auto count = [&](coupler::Verdict verdict) {
    return std::ranges::count(checks, verdict, &coupler::Check::verdict);
  };
  fmt::print("{} passed, {} warned, {} failed, {} not reached or not applicable\n",
             count(coupler::Verdict::pass), count(coupler::Verdict::warning),
             count(coupler::Verdict::failure), count(coupler::Verdict::skipped));
  if (!coupler::conforms(checks))
    throw Exit{1};
}

} // namespace

void add_conform(Command& app) {
  auto* command = app.add_subcommand(
      "conform", "Check a free-field program of your own: protocol, units, points, timing, determinism");
  const auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("PROGRAM", arguments->command,
                   "The program and its own arguments; write -- before it where they begin with a dash")
      ->required();
  command
      ->add_option("--case", arguments->case_file,
                   "Case that it shall serve; without it a box of 20 m x 10 m under a vertical SV pulse")
      ->existing_file();
  command->add_option(
      "--name", arguments->name,
      "Which free field of the case, as `tremolo explain` names it, e.g. left-right-base where one "
      "serves all; without it the case's first");
  command->callback([arguments] { conform(*arguments); });
}

} // namespace tremolo::app
