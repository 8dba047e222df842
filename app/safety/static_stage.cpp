#include "app/safety/static_stage.hpp"

#include "scene/plan/stages/stages.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace tremolo::app {

namespace {

/// Whether a stage ends with the ground at rest.
bool is_static(const scene::PlannedStage& stage) {
  return stage.kind == "gravity" || stage.kind == "load";
}

std::vector<std::string_view> names_of(const std::vector<scene::PlannedStage>& stages) {
  std::vector<std::string_view> names;
  names.reserve(stages.size());
  for (const scene::PlannedStage& stage : stages)
    names.push_back(stage.name);
  return names;
}

} // namespace

scene::Case at_end_of(scene::Case scene, const std::string& stage) {
  const auto all = scene::stages(scene);
  std::vector<scene::PlannedStage> possible = all;
  std::erase_if(possible, [](const scene::PlannedStage& one) { return !is_static(one); });
  const auto names = names_of(possible);
  if (std::ranges::find(names, stage) == names.end()) {
    if (const auto moving = std::ranges::find(all, stage, &scene::PlannedStage::name); moving != all.end())
      throw std::invalid_argument(
          fmt::format("--stage {}: the ground is not at rest in a stage of kind '{}'; possible are {}", stage,
                      moving->kind, fmt::join(names, ", ")));
    throw std::invalid_argument(
        fmt::format("--stage {}: no stage has this name, {}", stage, scene::suggestion(stage, names)));
  }
  const auto later = std::ranges::find(scene.loads, stage, &scene::LoadStage::name);
  scene.loads.erase(later == scene.loads.end() ? scene.loads.begin() : std::next(later), scene.loads.end());
  return scene;
}

} // namespace tremolo::app
