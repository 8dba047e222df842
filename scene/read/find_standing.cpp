// Finds the items present in each stage. A name that is placed before it is removed is absent at the start;
// all others are present. Each construction stores the items present until it, the case those present after
// the last construction before the shaking, with which the ground is shaken, and each earthwork after a
// shaking those that it places and removes, and those present from then on.

#include "scene/read/read.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tremolo::scene {

namespace {

/// Whether a named item is present, and which stage last changed that.
struct State {
  bool stands = true;
  std::string changed = {}; ///< in the stage of this name; empty: never
};

using States = std::map<std::string, State, std::less<>>;

/// All named items, as they are at the start.
States states_at_start(const Case& scene) {
  States states;
  for (const Region& region : scene.regions)
    if (!region.name.empty())
      states.try_emplace(region.name);
  for (const Structure& structure : scene.structures)
    states.try_emplace(structure.name);
  for (const Prop& prop : scene.props)
    states.try_emplace(prop.name);
  std::set<std::string_view> seen;
  const auto follow = [&](const auto& stage) {
    for (const std::string& name : stage.remove)
      seen.insert(name);
    for (const std::string& name : stage.place)
      if (const auto state = states.find(name); state != states.end() && seen.insert(name).second)
        state->second.stands = false;
  };
  std::ranges::for_each(scene.constructions, follow);
  std::ranges::for_each(scene.earthworks, follow);
  return states;
}

Standing standing(const Case& scene, const States& states) {
  Standing found;
  const auto stands = [&](const std::string& name) {
    const auto state = states.find(name);
    return state == states.end() || state->second.stands;
  };
  std::ranges::copy_if(scene.regions, std::back_inserter(found.regions), stands, &Region::name);
  std::ranges::copy_if(scene.structures, std::back_inserter(found.structures), stands, &Structure::name);
  std::ranges::copy_if(scene.props, std::back_inserter(found.props), stands, &Prop::name);
  return found;
}

void refuse_shared_names(const Case& scene, Findings& findings) {
  const auto compare = [&](const auto& ones, const auto& others, const char* what) {
    for (const auto& other : others)
      for (const auto& one : ones)
        if (!one.name.empty() && one.name == other.name)
          findings.add(one.path + ".name",
                       fmt::format("the {} in line {} has the name '{}' too: stages could not tell one "
                                   "from the other",
                                   what, findings.place(other.path + ".name").line, one.name));
  };
  compare(scene.regions, scene.structures, "structure");
  compare(scene.regions, scene.props, "prop");
  compare(scene.structures, scene.props, "prop");
}

/// Changes what a stage places or removes.
template <class Stage>
void change(States& states, const Stage& stage, bool places, Findings& findings) {
  const std::string path = stage.path + (places ? ".place" : ".remove");
  for (const std::string& name : places ? stage.place : stage.remove) {
    const auto found = states.find(name);
    if (found == states.end()) {
      std::vector<std::string_view> known;
      for (const auto& [other, state] : states)
        known.push_back(other);
      findings.add(path, fmt::format("no [[region]], [[structure]] or [[prop]] has the name '{}'{}", name,
                                     known.empty() ? ": none has one" : ", " + suggestion(name, known)));
      continue;
    }
    State& state = found->second;
    if (state.stands == places) {
      const std::string since = !state.changed.empty() ? fmt::format("since the stage '{}'", state.changed)
                                                       : std::string(places ? "from the start" : "yet");
      findings.add(path, places ? fmt::format("'{}' stands already, {}", name, since)
                                : fmt::format("'{}' cannot go: it is not there {}", name, since));
      continue;
    }
    state = {places, stage.name};
  }
}

/// The regions of these names; structures and props are refused.
std::vector<Region> regions_of(const Case& scene, const std::vector<std::string>& names,
                               const std::string& path, Findings& findings) {
  std::vector<Region> regions;
  for (const std::string& name : names) {
    const auto refuse = [&](const auto& all, const char* what) {
      if (std::ranges::find(all, name, [](const auto& one) { return one.name; }) != all.end())
        findings.add(
            path, fmt::format("'{}' is a {}: after a shaking soil alone is placed and removed", name, what));
    };
    refuse(scene.structures, "structure");
    refuse(scene.props, "prop");
    std::ranges::copy_if(scene.regions, std::back_inserter(regions),
                         [&](const Region& region) { return region.name == name; });
  }
  return regions;
}

/// Items attached to a structure get its index among the structures present at the end.
/// @param why  the reason, for the message, that the item needs a structure
void renumber(std::optional<std::size_t>& structure, const std::string& path, std::string_view why,
              const Case& scene, const Standing& end, Findings& findings) {
  if (!structure)
    return;
  const std::string name = scene.structures[*structure].name;
  const auto found = std::ranges::find(end.structures, name, &Structure::name);
  if (found == end.structures.end()) {
    structure.reset();
    findings.add(path + ".structure",
                 fmt::format("the structure '{}' is removed before the shaking: {}", name, why));
  } else {
    structure = static_cast<std::size_t>(found - end.structures.begin());
  }
}

} // namespace

void find_standing(Case& scene, Findings& findings) {
  if (scene.constructions.empty() && scene.earthworks.empty())
    return;
  refuse_shared_names(scene, findings);
  States states = states_at_start(scene);
  for (ConstructionStage& stage : scene.constructions) {
    Standing before = standing(scene, states);
    stage.before.regions = std::move(before.regions);
    stage.before.structures = std::move(before.structures);
    stage.before.props = std::move(before.props);
    change(states, stage, false, findings);
    change(states, stage, true, findings);
  }
  Standing end = standing(scene, states);
  for (Earthwork& work : scene.earthworks) {
    work.placed = regions_of(scene, work.place, work.path + ".place", findings);
    work.removed = regions_of(scene, work.remove, work.path + ".remove", findings);
    change(states, work, false, findings);
    change(states, work, true, findings);
    work.after = standing(scene, states);
  }
  for (std::size_t m = 0; m < scene.monitors.size(); ++m)
    renumber(scene.monitors[m].structure, fmt::format("monitor[{}]", m), "a monitor cannot ride on it", scene,
             end, findings);
  for (Section& section : scene.sections)
    renumber(section.structure, section.path, "a section cannot cut it", scene, end, findings);
  scene.regions = std::move(end.regions);
  scene.structures = std::move(end.structures);
  scene.props = std::move(end.props);
}

} // namespace tremolo::scene
