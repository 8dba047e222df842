#include "scene/read/read.hpp"
#include "scene/read/soil/read_water.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace tremolo::scene {

namespace {

/// The name of a stage, and where it stands.
struct StageName {
  std::string name;
  std::string path;
};

/// The name that a stage has been given, or its kind; refused where an earlier stage has it.
std::string read_name(const TableReader& table, const std::string& kind, std::vector<StageName>& earlier,
                      Findings& findings) {
  const std::string given = table.text("name");
  std::string name = given.empty() ? kind : given;
  const std::string path = given.empty() ? table.path("kind") : table.path("name");
  for (const StageName& other : earlier)
    if (other.name == name)
      findings.add(path, fmt::format("the stage in line {} has the name '{}' already: give one of both "
                                     "another 'name'",
                                     findings.place(other.path).line, name));
  earlier.push_back({name, path});
  return name;
}

/// What static stages after gravity have in common.
void read_static(StaticStage& stage, const TableReader& table, const std::string& name, const Case& so_far,
                 bool shaken, Findings& findings) {
  stage.name = name;
  stage.ramp = table.optional_number("ramp_s");
  stage.residual = table.number("residual");
  stage.max_time = table.number("max_time_s");
  stage.undrained = table.choice<StageDrainage>("drainage") == StageDrainage::undrained;
  stage.path = table.path();
  const std::string kind = table.text("kind");
  const char* const suffix = kind == "water" ? " stage" : "";
  if (shaken || so_far.rest)
    findings.add(table.path("kind"), fmt::format("a {}{} must come before the shaking stage", kind, suffix));
  else if (!so_far.gravity)
    findings.add(table.path("kind"),
                 fmt::format("a {}{} must come after a gravity stage, whose relaxation it goes on with", kind,
                             suffix));
}

LoadStage read_load(const TableReader& table, Findings& findings) {
  const auto ends = table.numbers("x_m");
  if (ends.size() == 2 && !(ends[0] < ends[1]))
    findings.add(table.path("x_m"), fmt::format("'x_m' = [{:g}, {:g}] goes from right to left: the first end "
                                                "must be the smaller one",
                                                ends[0], ends[1]));
  LoadStage load;
  load.pressure = table.number("pressure_pa");
  load.shear = table.number("shear_pa");
  if (load.pressure == 0.0 && load.shear == 0.0 && findings.sound(table.path("pressure_pa")) &&
      findings.sound(table.path("shear_pa")))
    findings.add(table.path("pressure_pa"), "missing 'pressure_pa' or 'shear_pa': how large the load is");
  if (ends.size() == 2) {
    load.x_min = ends[0];
    load.x_max = ends[1];
  }
  return load;
}

ConstructionStage read_construction(const TableReader& table, const Case& so_far, Findings& findings) {
  ConstructionStage construction;
  construction.place = table.texts("place");
  construction.remove = table.texts("remove");
  construction.loads_before = so_far.loads.size();
  if (construction.place.empty() && construction.remove.empty() && findings.sound(table.path("place")) &&
      findings.sound(table.path("remove")))
    findings.add(table.path("place"), "missing 'place' or 'remove': what is built");
  return construction;
}

ConstructionStage read_change_of_water(const TableReader& table, const Case& so_far, Findings& findings) {
  ConstructionStage change;
  change.water = read_levels(table, findings);
  change.loads_before = so_far.loads.size();
  return change;
}

} // namespace

void read_stages(Document& document, Findings& findings, Case& scene) {
  bool shaken = false;
  bool legible = true;
  std::vector<StageName> names;
  for (const auto& table : document.array("stage")) {
    const auto kind = table.text("kind");
    legible = legible && !kind.empty();
    const bool again = (kind == "gravity" && scene.gravity) || (kind == "shaking" && shaken) ||
                       (kind == "rest" && scene.rest);
    const auto name_of_stage = [&] { // a second one of its kind is refused for that alone
      return again ? kind : read_name(table, kind, names, findings);
    };
    if (kind == "gravity") {
      if (scene.gravity || shaken || scene.rest)
        findings.add(table.path("kind"), scene.gravity
                                             ? "a second gravity stage: there can be at most one"
                                             : "the gravity stage must come before the shaking stage");
      else if (!scene.loads.empty() || !scene.constructions.empty())
        findings.add(table.path("kind"), fmt::format("the gravity stage must come before a {}",
                                                     scene.loads.empty() ? "construction" : "load"));
      scene.gravity = GravityStage{name_of_stage(), table.number("acceleration"), table.number("residual"),
                                   table.number("max_time_s")};
    }
    if (kind == "load") {
      LoadStage load = read_load(table, findings);
      read_static(load, table, name_of_stage(), scene, shaken, findings);
      scene.loads.push_back(std::move(load));
    }
    if (kind == "construction" || kind == "water") {
      ConstructionStage construction = kind == "water" ? read_change_of_water(table, scene, findings)
                                                       : read_construction(table, scene, findings);
      read_static(construction, table, name_of_stage(), scene, shaken, findings);
      scene.constructions.push_back(std::move(construction));
    }
    if (kind == "shaking") {
      if (shaken || scene.rest)
        findings.add(table.path("kind"), shaken ? "a second shaking stage: there must be exactly one"
                                                : "the shaking stage must come before the rest");
      scene.shaking = {name_of_stage(), table.number("duration_s")};
      shaken = true;
    }
    if (kind == "rest") {
      if (scene.rest)
        findings.add(table.path("kind"), "a second rest: there can be at most one");
      scene.rest = RestStage{.name = name_of_stage(),
                             .duration = table.number("duration_s"),
                             .time_factor = table.number("time_factor"),
                             .until_ratio = table.optional_number("until_ratio"),
                             .every = table.optional_number("every_s"),
                             .growth = table.number("growth"),
                             .history_every = table.optional_number("history_every_s")};
    }
  }
  if (!shaken && legible && findings.sound("stage"))
    findings.add("stage", "missing [[stage]] of kind = \"shaking\": how long the motion acts");
}

} // namespace tremolo::scene
