// A stage may set the drainage of each soil separately. It must not name soil that has no pore water, or soil
// whose own drainage fixes its pressure.

#include "scene/plan/stages/stages.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/rules/rules.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::scene {

namespace {

/// Why a stage cannot say what the pore water of a soil does; empty if it can.
/// @param then  the case with the model of the stage
std::string lack_of_water(const Case& then, const StaticStage& stage, const std::string& name) {
  const auto soil = std::ranges::find(then.soils, name, &Soil::name);
  if (soil == then.soils.end()) {
    std::vector<std::string_view> names;
    for (const Soil& one : then.soils) // slices of a soil have one name
      if (names.empty() || names.back() != one.name)
        names.push_back(one.name);
    return fmt::format("no soil has the name '{}', {}", name, suggestion(name, names));
  }
  const auto wet = soils_below_table(then);
  if (std::ranges::none_of(wet, [&](const Soil& one) { return one.name == name; }))
    return fmt::format("soil '{}' does not lie below water in the stage '{}', and has no water that could "
                       "move or stay: leave it out",
                       name, stage.name);
  if (soil->pores && soil->pores->drainage == materials::Drainage::drained)
    return fmt::format(
        "soil '{}' has a drainage of its own, \"drained\", by which its pressure stays what it "
        "is: leave it out, or let the soil be \"coupled\" or \"undrained\"",
        name);
  return {};
}

} // namespace

void drainage_is_of_soils(const Case& scene, Findings& findings) {
  const std::vector<BeforeShaking> stages = static_stages(scene);
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const StaticStage& stage =
        std::visit([](const auto* one) -> const StaticStage& { return *one; }, stages[s]);
    if (stage.drainage.empty())
      continue;
    const Case then = model_of_stage(scene, s + 1); // stage 0 is gravity
    for (const auto& [soil, drainage] : stage.drainage)
      if (const std::string lack = lack_of_water(then, stage, soil); !lack.empty())
        findings.add(fmt::format("{}.drainage.{}", stage.path, soil), lack);
  }
}

} // namespace tremolo::scene
