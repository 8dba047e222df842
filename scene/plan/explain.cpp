#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/section/section_cuts.hpp"
#include "scene/plan/stages/stages.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/random/random_text.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/ground_column.hpp"
#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace tremolo::scene {

namespace {

std::string size_text(double bytes) {
  if (bytes < 1e6)
    return fmt::format("{:.0f} kB", bytes / 1e3);
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6) : fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string duration_text(double seconds) {
  if (seconds < 90.0)
    return fmt::format("{:.0f} s", seconds);
  return seconds < 5400.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                          : fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string cost_text(const Effect& effect) {
  std::string text;
  if (effect.bytes_per_particle > 0.0)
    text += fmt::format("{:.0f} bytes", effect.bytes_per_particle);
  if (effect.ns_per_particle_step > 0.0)
    text += fmt::format("{}about {:.0f} ns a step", text.empty() ? "" : ", ", effect.ns_per_particle_step);
  return text.empty() ? "" : fmt::format(" ({} per particle)", text);
}

std::string motion_text(const Case& scene, const MotionInput& motion) {
  std::string source;
  for (const ShakingMotion& shaking : motion.shakings) {
    if (shaking.stage > 0)
      source += fmt::format(", from {:g} s ", scene.timed[shaking.stage].start);
    if (const auto* pulse = std::get_if<RickerPulse>(&shaking.source))
      source += fmt::format("Ricker pulse of {} Hz, {} m/s at {} s", pulse->frequency, pulse->velocity,
                            pulse->time);
    else
      source += std::get<MotionFile>(shaking.source).path.filename().string();
  }
  if (!scene.boundary.takes_waves())
    return fmt::format("{}, of a shaking table along {}", source, motion.wave == Wave::sv ? "x" : "y");
  return fmt::format("{}, {} motion of the {} wave at {} degrees, given at ({}, {})", source,
                     name(motion.kind), name(motion.wave), motion.angle_deg, motion.reference.x,
                     motion.reference.y);
}

std::string sides_text(const SourceProcess& source) {
  std::string text;
  for (const Served& served : source.serves)
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", name(served.side), name(served.field));
  return text;
}

std::string layers_text(const std::vector<Layer>& layers) {
  return layers.empty() ? "no layers"
                        : fmt::format("{} layer{}", layers.size(), layers.size() == 1 ? "" : "s");
}

/// The ground below the surface of a free field's source.
std::string ground_text(const Case& scene, const SourceProcess& source) {
  if (!scene.boundary.has_ground_below())
    return {};
  const std::string water = scene.water && !scene.water->is_level() && traits(source.field.model).computed
                                ? fmt::format(", water table at y = {} m", water_level(scene, source))
                                : "";
  return fmt::format(", surface at y = {} m, {}{}", source.surface, layers_text(layers(scene, source)),
                     water);
}

/// "0.5 m", or "1 to 0.25 m"
std::string cell_sizes_text(const std::vector<Level>& levels) {
  return levels.size() == 1 ? fmt::format("{} m", levels.front().cell_size)
                            : fmt::format("{} to {} m", levels.front().cell_size, levels.back().cell_size);
}

/// The machines on which ranks of the domain run, if there are any.
std::string ranks_text(const Case& scene) {
  if (!scene.hosts.domain)
    return {};
  const RankHosts& hosts = *scene.hosts.domain;
  std::string text = "    its ranks with --ranks N: ";
  if (hosts.start == StartRanksBy::slurm)
    return text + "on the nodes of the Slurm job\n";
  text += "here";
  for (const RankMachine& machine : hosts.machines)
    text +=
        fmt::format(", {}{}", machine.name, machine.most ? fmt::format(" (at most {})", *machine.most) : "");
  return text + ", through ssh\n";
}

std::string steps_text(int steps) {
  return steps == 1 ? "1 step" : fmt::format("{} steps", steps);
}

/// A line for each of several levels.
std::string levels_text(const std::vector<Level>& levels) {
  if (levels.size() == 1)
    return {};
  const bool own_steps = levels.back().dt < levels.front().dt;
  std::string text;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const Level& of = levels[level];
    text += fmt::format("    level {}  {:.0f} cells of {} m, {:.0f} particles of {} m, ", level, of.cells,
                        of.cell_size, of.particles, of.particle_size);
    text += std::isfinite(of.critical_dt) ? fmt::format("critical step {:.4g} s", of.critical_dt)
                                          : std::string("no soil");
    text += own_steps ? fmt::format(", {} of {:.4g} s\n", steps_text(1 << level), of.dt) : "\n";
  }
  return text;
}

/// The slices of a soil and what varies between them.
std::string profile_text(const SoilProfile& profile) {
  std::string lines = fmt::format(
      "  varies over depth: {} slice{} from y = {:g} to {:g} m, each with the values of its middle\n",
      profile.slices(), profile.slices() == 1 ? "" : "s", profile.levels.front(), profile.levels.back());
  for (const VaryingKey& key : profile.keys) {
    const auto [least, most] = std::ranges::minmax(key.values);
    lines += fmt::format("  {:<26} {:>12.6g} to {:.6g}{}; {}\n", key.key, least, most,
                         key.unit == "1" ? "" : " " + key.unit, key.profile);
  }
  return lines;
}

std::string soils_text(const Case& scene) {
  std::string lines = "\nSoils\n";
  for (const Soil& soil : one_of_each_name({scene.soils.begin(), scene.soils.end()})) {
    lines += fmt::format(" {} ({})\n", soil.name, model_in_force("soil." + soil.name, scene.values));
    const auto profile = std::ranges::find_if(
        scene.soil_profiles, [&](const SoilProfile& one) { return &scene.soils[one.first] == &soil; });
    auto parameters = parameters_in_force(soil, "soil." + soil.name, scene.values);
    if (profile != scene.soil_profiles.end()) {
      lines += profile_text(*profile);
      std::erase_if(parameters, [&](const ParameterInForce& one) {
        return std::ranges::find(profile->keys, one.name, &VaryingKey::key) != profile->keys.end();
      });
      if (!parameters.empty())
        lines += "  and in the uppermost slice\n";
    }
    lines += text(parameters);
  }
  return lines;
}

} // namespace

std::string explain(const Case& scene, const Plan& plan) {
  std::string text = fmt::format("{}\n", scene.title);
  for (const MotionInput* wave : scene.plane_waves())
    text +=
        fmt::format("  {}     {}\n", wave == &scene.motion ? "motion" : "  and ", motion_text(scene, *wave));
  text += "\nStages\n" + stages_text(scene);
  text += "\nEffects\n";
  for (const Effect& effect : plan.effects)
    text += fmt::format("  {:<4}{:<20}{}{}\n", effect.on ? "on" : "off", effect.name, effect.why,
                        cost_text(effect));
  text += fmt::format("\nProcesses\n  {:<16}{:<18}particles, boundary faces\n", "tremolo-domain", "domain");
  text += ranks_text(scene);
  for (const SourceProcess& source : plan.sources)
    text += fmt::format("  {:<16}{:<18}model {}{}; serves {}\n", program(source.field), source.name,
                        name(source.field.model), ground_text(scene, source), sides_text(source));
  text += fmt::format("  base       {}\n", plan.base);
  text += fmt::format("\nSize\n"
                      "  particles  {}, in a grid of {} cells of {}\n{}"
                      "  time step  {:.4g} s ({:.2f} of the critical {:.4g} s), {} steps for {:.4g} s{}\n"
                      "             {}\n"
                      "  memory     {} of arrays in the domain\n"
                      "  output     at most {} in run.h5 and run.xdmf, {} particle frames\n"
                      "  time       about {} on one thread for these steps, of the order of magnitude\n",
                      plan.particles, plan.cells, cell_sizes_text(plan.levels), levels_text(plan.levels),
                      plan.dt, plan.dt / plan.critical_dt, plan.critical_dt, plan.steps, scene.end(),
                      scene.end() < scene.end_of_soil_time()
                          ? fmt::format(", in which {:g} s of the soil's time pass", scene.end_of_soil_time())
                          : "",
                      step_limit_text(plan.limit), size_text(plan.memory_bytes), size_text(plan.output_bytes),
                      plan.frames, duration_text(plan.estimated_time));
  text += soils_text(scene);
  if (scene.random_profile)
    text += fmt::format("\n{}", random_profile_text(scene));
  if (scene.water)
    text += "\nWater\n  " + water_text(scene);
  if (!plan.structures.empty())
    text += "\nStructures\n" + structures_text(scene, plan.structures);
  if (!scene.sections.empty())
    text += "\nSections\n" + sections_text(scene);
  if (!plan.props.empty())
    text += "\nProps\n" + props_text(scene, plan.props);
  if (!plan.linings.empty())
    text += "\nLinings\n" + linings_text(scene, plan.linings, plan.dt);
  text += "\nRemarks\n";
  return text + remarks_text(scene);
}

std::string remarks_text(const Case& scene) {
  std::string text;
  for (const Finding& remark : scene.remarks)
    text += fmt::format("  {}\n", remark.message());
  return text;
}

namespace {

/// The ground of a side's free field, from the surface to the base of the domain; nothing of a recording and
/// of a program of the user, whose ground is not known.
nlohmann::ordered_json layers_json(const Case& scene, const LateralBoundary& side) {
  auto json = nlohmann::ordered_json::array();
  if (!traits(side.field.model).computed)
    return json;
  for (const GroundPiece& piece : ground_of_free_field(scene, side)) {
    json.push_back({{"top_m", piece.top}, {"bottom_m", piece.bottom}, {"soil", nullptr}});
    if (piece.soil)
      json.back()["soil"] = scene.soils[*piece.soil].name;
  }
  return json;
}

} // namespace

std::string to_json(const Case& scene, const Plan& plan) {
  using nlohmann::ordered_json;
  ordered_json json;
  for (const Effect& effect : plan.effects)
    json["effects"].push_back({{"name", effect.name},
                               {"on", effect.on},
                               {"why", effect.why},
                               {"bytes_per_particle", effect.bytes_per_particle},
                               {"ns_per_particle_step", effect.ns_per_particle_step}});
  for (const SourceProcess& source : plan.sources) {
    ordered_json serves;
    for (const Served& served : source.serves)
      serves[std::string(name(served.side))] = name(served.field);
    json["sources"].push_back({{"program", program(source.field)},
                               {"model", name(source.field.model)},
                               {"name", source.name},
                               {"surface_m", source.surface},
                               {"serves", serves}});
  }
  if (scene.boundary.has_lateral_fields())
    for (const auto& [side, field] :
         {std::pair(Side::left, &scene.boundary.left), std::pair(Side::right, &scene.boundary.right)})
      json["free_field"][std::string(name(side))] = layers_json(scene, *field);
  for (const PlannedStage& stage : stages(scene)) {
    json["stages"].push_back(
        {{"name", stage.name}, {"kind", stage.kind}, {"changes", stage.changes}, {"lasts", stage.lasts}});
    if (const auto timed = std::ranges::find(scene.timed, stage.name, &TimedStage::name);
        timed != scene.timed.end()) {
      json["stages"].back()["from_s"] = timed->start;
      json["stages"].back()["to_s"] = timed->end();
    }
  }
  json["base"] = plan.base;
  json["notes"] = ordered_json::array();
  for (const Finding& remark : scene.remarks)
    json["notes"].push_back(remark.text);
  for (const Level& level : plan.levels)
    json["levels"].push_back({{"cell_size_m", level.cell_size},
                              {"particle_size_m", level.particle_size},
                              {"cells", level.cells},
                              {"particles", level.particles},
                              {"critical_dt_s", level.critical_dt},
                              {"dt_s", level.dt}});
  for (const PlannedStructure& structure : plan.structures)
    json["structures"].push_back({{"name", structure.name},
                                  {"area_m2", structure.area},
                                  {"mass_kg_per_m", structure.mass},
                                  {"weight_N_per_m", structure.weight},
                                  {"buoyancy_N_per_m", structure.buoyancy},
                                  {"contact_nodes", structure.contact_nodes},
                                  {"bytes", structure.bytes}});
  for (const Section& section : scene.sections) {
    json["sections"].push_back({{"name", section.name},
                                {"structure", scene.structures[*section.structure].name},
                                {"thickness_m", nlohmann::ordered_json::array()}});
    for (const SectionCut& cut : cuts_of(scene, section))
      json["sections"].back()["thickness_m"].push_back(cut.thickness());
  }
  for (const PlannedProp& prop : plan.props)
    json["props"].push_back(
        {{"name", prop.name}, {"length_m", prop.length}, {"critical_dt_s", prop.critical_step}});
  for (const PlannedLining& lining : plan.linings) {
    json["linings"].push_back({{"name", lining.name},
                               {"elements", lining.elements},
                               {"hinges", lining.hinges},
                               {"axis_m", lining.axis},
                               {"mass_kg_per_m", lining.mass},
                               {"explicit_dt_s", lining.explicit_step}});
    if (lining.ring)
      json["linings"].back().update(
          {{"ovaling_period_s", lining.ring->period}, {"flexibility_ratio", lining.ring->flexibility}});
  }
  json["particles"] = plan.particles;
  json["cells"] = plan.cells;
  json["critical_dt_s"] = plan.critical_dt;
  json["dt_s"] = plan.dt;
  json["steps"] = plan.steps;
  json["frames"] = plan.frames;
  json["memory_bytes"] = plan.memory_bytes;
  json["output_bytes"] = plan.output_bytes;
  json["estimated_time_s"] = plan.estimated_time;
  return json.dump(2);
}

} // namespace tremolo::scene
