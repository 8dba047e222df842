#include "scene/read/read.hpp"
#include "scene/read/soil/read_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
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

/// Drainage, for all soils or soil by soil.
void read_drainage(StaticStage& stage, const TableReader& table, const std::string& kind,
                   Findings& findings) {
  stage.undrained = table.choice<StageDrainage>("drainage") == StageDrainage::undrained;
  for (const auto& [soil, word] : table.words_by_name("drainage"))
    stage.drainage.emplace(soil, *value_named<StageDrainage>(word));
  stage.undrained = stage.undrained || !stage.undrained_soils().empty();
  if (kind == "water" && !stage.drainage.empty())
    findings.add(
        table.path("drainage"),
        "'drainage' of a stage of kind \"water\" must be \"drained\" or \"undrained\" for all soils: "
        "the level up to which soil stays wet is one");
}

/// When a load or a construction after a shaking begins; it grows within `ramp_s` while the ground goes on in
/// its own time, and soil rests.
/// @returns when that is, of the soil's time, s
double read_in_time(const TableReader& table, const std::string& name, Case& scene, Findings& findings) {
  for (const char* const key : {"residual", "max_time_s", "drainage"})
    if (table.given(key))
      findings.add(
          table.path(key),
          fmt::format("'{}' is of stages before the shaking, which relax to rest: after it the ground "
                      "goes on in its own time, and water flows as it does; leave it out",
                      key));
  if (!table.given("ramp_s"))
    findings.add(table.path("ramp_s"),
                 "missing 'ramp_s': after a shaking the change grows in the soil's own time, and the stage "
                 "lasts as long");
  const double start = scene.end_of_soil_time();
  scene.timed.push_back({.name = name,
                         .start = start,
                         .duration = table.optional_number("ramp_s").value_or(1.0),
                         .rest = Rest{},
                         .path = table.path()});
  return start;
}

/// Keys common to all static stages after gravity.
void read_static(StaticStage& stage, const TableReader& table, const std::string& name, const Case& so_far,
                 Findings& findings) {
  stage.name = name;
  stage.ramp = table.optional_number("ramp_s");
  stage.residual = table.number("residual");
  stage.max_time = table.number("max_time_s");
  stage.path = table.path();
  const std::string kind = table.text("kind");
  read_drainage(stage, table, kind, findings);
  const char* const suffix = kind == "water" ? " stage" : "";
  if (!so_far.timed.empty() && kind == "water")
    findings.add(table.path("kind"),
                 "a water stage must come before the shaking stage: after it water flows in "
                 "its own time, and the free fields keep their level");
  else if (!so_far.gravity)
    findings.add(table.path("kind"),
                 fmt::format("a {}{} must come after a gravity stage, whose relaxation it goes on with", kind,
                             suffix));
}

/// A load on a structure, which has no place and no pressure of its own.
LoadStage read_load_on_structure(const TableReader& table, Findings& findings) {
  LoadStage load;
  load.structure = table.text("structure");
  for (const char* const key : {"x_m", "pressure_pa", "shear_pa"})
    if (table.given(key))
      findings.add(table.path(key),
                   fmt::format("'{}' is of a load on the surface, and this one is on the structure '{}': "
                               "leave one of both out",
                               key, load.structure));
  if (!table.given("force_n_per_m"))
    findings.add(table.path("force_n_per_m"),
                 "missing 'force_n_per_m' = [fx, fy]: what acts on the structure");
  load.force = table.point("force_n_per_m");
  return load;
}

LoadStage read_load(const TableReader& table, Findings& findings) {
  if (table.given("structure"))
    return read_load_on_structure(table, findings);
  if (table.given("force_n_per_m"))
    findings.add(table.path("force_n_per_m"),
                 "'force_n_per_m' is of a load on a structure: give 'structure', its name");
  if (!table.given("x_m"))
    findings.add(table.path("x_m"), "missing 'x_m' or 'structure': where the load acts");
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

/// [stage.motion] of the stage that has been read last.
void read_shaking_motion(const TableReader& table, bool first, Case& scene, Findings& findings) {
  const TimedStage& stage = scene.timed.back();
  if (first || stage.rest) {
    findings.add(table.path(), stage.rest
                                   ? "[stage.motion] does not apply to kind = \"rest\", only to shaking"
                                   : "[stage.motion] is that of a later shaking; the first one has [motion]");
    return;
  }
  ShakingMotion shaking{.stage = scene.timed.size() - 1,
                        .start = scene.clock().simulated_time(stage.start),
                        .path = table.path()};
  if (const auto vertical = table.table("vertical")) {
    if (!scene.vertical)
      scene.vertical.emplace();
    ShakingMotion beside{.stage = shaking.stage, .start = shaking.start, .path = vertical->path()};
    if (auto source = read_motion_source(*vertical, scene, findings))
      beside.source = *std::move(source);
    scene.vertical->shakings.push_back(std::move(beside));
  }
  if (auto source = read_motion_source(table, scene, findings))
    shaking.source = *std::move(source);
  scene.motion.shakings.push_back(std::move(shaking));
}

Rest read_rest(const TableReader& table, Findings& findings) {
  for (const char* const key : {"every_s", "growth"})
    if (table.given("times_s") && table.given(key))
      findings.add(
          table.path(key),
          fmt::format("'{}' and 'times_s' both say when frames are written: leave one of both out", key));
  const std::vector<double> times = table.numbers("times_s");
  if (!std::ranges::is_sorted(times, std::less_equal<>()) || (!times.empty() && !(times.front() > 0.0)))
    findings.add(table.path("times_s"),
                 "'times_s' must rise, from more than 0 s: times after the start of the rest");
  else if (!times.empty() && times.back() > table.number("duration_s"))
    findings.add(table.path("times_s"),
                 fmt::format("'times_s' goes to {:g} s, and the rest ends after {:g} s", times.back(),
                             table.number("duration_s")));
  return {.time_factor = table.number("time_factor"),
          .until_ratio = table.optional_number("until_ratio"),
          .every = table.optional_number("every_s"),
          .growth = table.number("growth"),
          .times = times,
          .history_every = table.optional_number("history_every_s")};
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

Earthwork read_earthwork(const TableReader& table, const std::string& name, Case& scene, Findings& findings) {
  ConstructionStage construction = read_construction(table, scene, findings);
  const double start = read_in_time(table, name, scene, findings);
  return {.name = name,
          .start = start,
          .ramp = scene.timed.back().duration,
          .place = std::move(construction.place),
          .remove = std::move(construction.remove),
          .placed = {},
          .removed = {},
          .after = {},
          .path = table.path()};
}

bool is_shaken(const Case& so_far) {
  return std::ranges::any_of(so_far.timed, [](const TimedStage& stage) { return !stage.rest; });
}

/// A shaking or a rest. Its motion begins when all before it is over.
void read_timed(const TableReader& table, const std::string& name, Case& scene, Findings& findings) {
  const bool rests = table.text("kind") == "rest";
  const bool first = !is_shaken(scene);
  if (rests && first)
    findings.add(table.path("kind"), "a rest must come after a shaking stage");
  scene.timed.push_back({.name = name,
                         .start = scene.end_of_soil_time(),
                         .duration = table.number("duration_s"),
                         .rest = rests ? std::optional(read_rest(table, findings)) : std::nullopt,
                         .path = table.path()});
  if (const auto motion = table.table("motion"))
    read_shaking_motion(*motion, first, scene, findings);
  else if (!rests && !first)
    findings.add(table.path("motion"),
                 "missing [stage.motion], a 'file' or a 'pulse': what the ground is shaken with again");
}

} // namespace

void read_stages(Document& document, Findings& findings, Case& scene) {
  bool legible = true;
  std::vector<StageName> names;
  for (const auto& table : document.array("stage")) {
    const auto kind = table.text("kind");
    legible = legible && !kind.empty();
    const bool again = kind == "gravity" && scene.gravity;
    const auto name_of_stage = [&] { // a second one of its kind is refused for that alone
      return again ? kind : read_name(table, kind, names, findings);
    };
    if (kind == "gravity") {
      if (again || !scene.timed.empty())
        findings.add(table.path("kind"), again ? "a second gravity stage: there can be at most one"
                                               : "the gravity stage must come before the shaking stage");
      else if (!scene.loads.empty() || !scene.constructions.empty())
        findings.add(table.path("kind"), fmt::format("the gravity stage must come before a {}",
                                                     scene.loads.empty() ? "construction" : "load"));
      scene.gravity = GravityStage{name_of_stage(), table.number("acceleration"), table.number("residual"),
                                   table.number("max_time_s")};
    }
    if (kind == "load") {
      LoadStage load = read_load(table, findings);
      const std::string name = name_of_stage();
      read_static(load, table, name, scene, findings);
      if (is_shaken(scene))
        load.start = read_in_time(table, name, scene, findings);
      scene.loads.push_back(std::move(load));
    }
    if (kind == "construction" && is_shaken(scene)) {
      scene.earthworks.push_back(read_earthwork(table, name_of_stage(), scene, findings));
    } else if (kind == "construction" || kind == "water") {
      ConstructionStage construction = kind == "water" ? read_change_of_water(table, scene, findings)
                                                       : read_construction(table, scene, findings);
      read_static(construction, table, name_of_stage(), scene, findings);
      scene.constructions.push_back(std::move(construction));
    }
    if (kind == "shaking" || kind == "rest")
      read_timed(table, name_of_stage(), scene, findings);
  }
  if (legible && findings.sound("stage") && !is_shaken(scene))
    findings.add("stage", "missing [[stage]] of kind = \"shaking\": how long the motion acts");
  for (std::size_t i = 0; i + 1 < scene.timed.size(); ++i)
    if (const TimedStage& stage = scene.timed[i]; stage.rest && stage.rest->until_ratio)
      findings.add(
          stage.path + ".until_ratio",
          fmt::format("'until_ratio' ends the last stage only, and '{}' comes after this rest: when it "
                      "begins must be known beforehand",
                      scene.timed[i + 1].name));
}

} // namespace tremolo::scene
