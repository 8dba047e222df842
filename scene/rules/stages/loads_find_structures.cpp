// A load on a structure needs one that stands in its stage.

#include "scene/plan/stages/stages.hpp"
#include "scene/rules/rules.hpp"
#include "scene/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::scene {

namespace {

/// The names of the structures that stand in some stage.
std::vector<std::string_view> all_structures(const Case& scene) {
  std::vector<std::string_view> names;
  const auto add = [&](const std::vector<Structure>& structures) {
    for (const Structure& structure : structures)
      if (std::ranges::find(names, structure.name) == names.end())
        names.push_back(structure.name);
  };
  for (const ConstructionStage& construction : scene.constructions)
    add(construction.before.structures);
  add(scene.structures);
  return names;
}

} // namespace

void loads_find_structures(const Case& scene, Findings& findings) {
  const std::vector<std::string_view> names = all_structures(scene);
  const std::vector<BeforeShaking> stages = static_stages(scene);
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const auto* const stage = std::get_if<const LoadStage*>(&stages[s]);
    if (stage == nullptr || !(*stage)->on_structure())
      continue;
    const LoadStage& load = **stage;
    const std::string path = load.path + ".structure";
    const Case then = model_of_stage(scene, s + 1); // stage 0 is gravity
    if (std::ranges::find(names, load.structure) == names.end())
      findings.add(path,
                   fmt::format("no [[structure]] has the name '{}'{}", load.structure,
                               names.empty() ? ": there is none" : ", " + suggestion(load.structure, names)));
    else if (std::ranges::find(then.structures, load.structure, &Structure::name) == then.structures.end())
      findings.add(path, fmt::format("the structure '{}' does not stand in the stage '{}': place it before, "
                                     "in a stage of kind \"construction\"",
                                     load.structure, load.name));
  }
}

} // namespace tremolo::scene
