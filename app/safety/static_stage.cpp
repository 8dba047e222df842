#include "app/safety/static_stage.hpp"

#include "scene/plan/stages/stages.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::app {

namespace {

std::string_view name_of(const scene::BeforeShaking& stage) {
  return std::visit([](const auto* one) -> std::string_view { return one->name; }, stage);
}

/// Why a name is none of a static stage.
std::string refusal(const scene::Case& scene, const std::string& stage,
                    const std::vector<std::string_view>& names) {
  const auto all = scene::stages(scene);
  const auto moving = std::ranges::find(all, stage, &scene::PlannedStage::name);
  if (moving == all.end())
    return fmt::format("--stage {}: no stage has this name, {}", stage, scene::suggestion(stage, names));
  return fmt::format("--stage {}: the ground is not at rest in a stage of kind '{}'; possible are {}", stage,
                     moving->kind, fmt::join(names, ", "));
}

} // namespace

scene::Case at_end_of(const scene::Case& scene, const std::string& stage) {
  const std::vector<scene::BeforeShaking> stages = scene::static_stages(scene);
  std::vector<std::string_view> names{scene.gravity->name};
  std::ranges::transform(stages, std::back_inserter(names), name_of);
  const auto named = std::ranges::find(names, stage);
  if (named == names.end())
    throw std::invalid_argument(refusal(scene, stage, names));
  const auto number = named - names.begin();
  scene::Case then = scene::model_of_stage(scene, static_cast<std::size_t>(number));
  const auto loads =
      std::count_if(stages.begin(), stages.begin() + number, [](const scene::BeforeShaking& one) {
        return std::holds_alternative<const scene::LoadStage*>(one);
      });
  then.loads.resize(static_cast<std::size_t>(loads));
  return then;
}

std::string last_static_stage(const scene::Case& scene) {
  const auto stages = scene::static_stages(scene);
  return stages.empty() ? scene.gravity->name : std::string(name_of(stages.back()));
}

} // namespace tremolo::app
