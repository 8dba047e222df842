#include "scene/plan/stages/stages.hpp"

#include "scene/plan/wet_soils.hpp"
#include "scene/soils/domain_soils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tremolo::scene {

namespace {

PlannedStage gravity(const GravityStage& stage) {
  return {stage.name, "gravity",
          fmt::format("weight of {:g} m/s2, base fixed, sides on rollers", stage.acceleration),
          fmt::format("until at rest to {:g}, at most {:g} s of relaxation", stage.residual, stage.max_time)};
}

/// "undrained, " or "undrained in 'clay' and 'silt', "; empty: all is drained.
std::string drainage_text(const StaticStage& stage) {
  if (!stage.undrained)
    return "";
  std::string soils;
  for (const std::string& soil : stage.undrained_soils())
    soils += fmt::format("{} '{}'", soils.empty() ? " in" : " and", soil);
  return fmt::format("undrained{}, ", soils);
}

/// A text on the duration of a static stage.
std::string relaxation(const Case& scene, const StaticStage& stage) {
  return fmt::format("grows in {:.3g} s of relaxation, {}then until at rest to {:g}, at most {:g} s",
                     ramp_of(scene, stage), drainage_text(stage), stage.residual, stage.max_time);
}

/// "removes 'pit', places 'cellar'"
std::string change_text(const std::vector<std::string>& remove, const std::vector<std::string>& place) {
  const auto list = [](const char* does, const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
      text += fmt::format("{}'{}'", text.empty() ? std::string(does) + " " : ", ", name);
    return text;
  };
  const std::string removed = list("removes", remove);
  const std::string placed = list("places", place);
  return removed + (removed.empty() || placed.empty() ? "" : ", ") + placed;
}

PlannedStage construction(const Case& scene, const ConstructionStage& stage) {
  if (stage.water)
    return {stage.name, "water", table_text(*stage.water), relaxation(scene, stage)};
  return {stage.name, "construction", change_text(stage.remove, stage.place), relaxation(scene, stage)};
}

/// A text on the duration of a change after a shaking.
std::string in_time(double ramp, double start) {
  return fmt::format("grows in {:g} s of the soil's own time, from {:g} s", ramp, start);
}

PlannedStage load(const Case& scene, const LoadStage& stage) {
  const std::string lasts = stage.start ? in_time(*stage.ramp, *stage.start) : relaxation(scene, stage);
  if (stage.on_structure())
    return {stage.name, "load",
            fmt::format("force of [{:g}, {:g}] N/m on the structure '{}', which stays", stage.force.x,
                        stage.force.y, stage.structure),
            lasts};
  std::string what;
  if (stage.pressure != 0.0)
    what = fmt::format("pressure of {:g} Pa", stage.pressure);
  if (stage.shear != 0.0)
    what += fmt::format("{}shear of {:g} Pa", what.empty() ? "" : ", ", stage.shear);
  return {
      stage.name, "load",
      fmt::format("{} on the surface from x = {:g} to {:g} m, which stays", what, stage.x_min, stage.x_max),
      lasts};
}

PlannedStage shaking(const Case& scene, const TimedStage& stage) {
  const bool first = stage.start == 0.0;
  const char* const model = scene.gravity
                                ? "the motion enters; static tractions hold what the constraints held"
                                : "the motion enters a model without weight";
  return {stage.name, "shaking",
          first ? model : "a motion of its own enters; sand has the stiffness of shaking again",
          fmt::format("{:g} s, from {:g} s", stage.duration, stage.start)};
}

PlannedStage rest(const TimedStage& stage) {
  std::string changes = "sand reconsolidates";
  if (stage.rest->time_factor > 1.0)
    changes += fmt::format(", time passes up to {:g} times as fast", stage.rest->time_factor);
  std::string lasts = fmt::format("{:g} s, from {:g} s", stage.duration, stage.start);
  if (stage.rest->until_ratio)
    lasts += fmt::format(", or until no excess pore pressure ratio is above {:g}", *stage.rest->until_ratio);
  return {stage.name, "rest", changes, lasts};
}

PlannedStage timed(const Case& scene, const TimedStage& stage) {
  if (const auto work = std::ranges::find(scene.earthworks, stage.name, &Earthwork::name);
      work != scene.earthworks.end())
    return {work->name, "construction", change_text(work->remove, work->place),
            in_time(work->ramp, work->start)};
  if (const auto of = std::ranges::find(scene.loads, stage.name, &LoadStage::name); of != scene.loads.end())
    return load(scene, *of);
  return stage.rest ? rest(stage) : shaking(scene, stage);
}

} // namespace

double slow_ramp(const Case& scene) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const Soil& soil : domain_soils(scene))
    slowest = std::min(slowest, materials::elasticity(soil.law).s_wave_speed());
  return 5.0 * 4.0 * scene.mesh.box.height() / slowest;
}

double ramp_of(const Case& scene, const StaticStage& stage) {
  return stage.ramp.value_or(slow_ramp(scene));
}

std::vector<BeforeShaking> static_stages(const Case& scene) {
  std::vector<BeforeShaking> all;
  auto next = scene.constructions.begin();
  for (std::size_t loads = 0; loads <= scene.loads.size(); ++loads) {
    for (; next != scene.constructions.end() && next->loads_before == loads; ++next)
      all.emplace_back(&*next);
    if (loads < scene.loads.size() && !scene.loads[loads].start)
      all.emplace_back(&scene.loads[loads]);
  }
  return all;
}

Case before_construction(const Case& scene, const ConstructionStage& construction) {
  Case then = scene;
  then.regions = construction.before.regions;
  then.structures = construction.before.structures;
  then.props = construction.before.props;
  then.water = construction.before.water;
  then.loads.resize(construction.loads_before);
  return then;
}

Case after_earthwork(const Case& scene, const Earthwork& work) {
  Case then = scene;
  then.regions = work.after.regions;
  then.structures = work.after.structures;
  then.props = work.after.props;
  return then;
}

Case model_of_stage(const Case& scene, std::size_t stage) {
  const std::vector<BeforeShaking> stages = static_stages(scene);
  for (std::size_t later = stage; later < stages.size(); ++later)
    if (const auto* next = std::get_if<const ConstructionStage*>(&stages[later]))
      return before_construction(scene, **next);
  return scene;
}

std::vector<PlannedStage> stages(const Case& scene) {
  std::vector<PlannedStage> all;
  if (scene.gravity)
    all.push_back(gravity(*scene.gravity));
  for (const BeforeShaking& stage : static_stages(scene))
    all.push_back(std::holds_alternative<const LoadStage*>(stage)
                      ? load(scene, *std::get<const LoadStage*>(stage))
                      : construction(scene, *std::get<const ConstructionStage*>(stage)));
  for (const TimedStage& stage : scene.timed)
    all.push_back(timed(scene, stage));
  return all;
}

std::string stages_text(const Case& scene) {
  std::string text;
  int number = 0;
  for (const PlannedStage& stage : stages(scene))
    text += fmt::format("  {}  {:<20}{:<14}{}; {}\n", ++number, stage.name, stage.kind, stage.changes,
                        stage.lasts);
  return text;
}

} // namespace tremolo::scene
