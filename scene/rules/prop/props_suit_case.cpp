#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void props_suit_case(const Case& scene, Findings& findings) {
  if (scene.gravity)
    return;
  const auto stressed =
      std::ranges::find_if(scene.props, [](const Prop& prop) { return prop.prestress.has_value(); });
  if (stressed != scene.props.end())
    findings.add(
        stressed->path + ".prestress",
        fmt::format("the prop '{}' has a prestress, but there is no [[stage]] of kind \"gravity\" in "
                    "which the ground could come to rest with it",
                    stressed->name));
}

} // namespace tremolo::scene
