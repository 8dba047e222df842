// Each end of a prop holds on to something: to a structure that stands as long as the prop does, or to soil.
// Two ends in the ground, or in one structure, would be a spring inside of a body.

#include "scene/rules/rules.hpp"
#include "scene/rules/run/places_in_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace tremolo::scene {

namespace {

/// Why an end holds on to nothing; empty: it does hold.
std::string why_loose(const Case& scene, const Prop& prop, const Prop::End& end) {
  const auto [x, y] = end.position;
  const std::string at = fmt::format("'at' [{:g}, {:g}]", x, y);
  if (end.structure.empty()) {
    if (const Structure* const around = structure_around(scene, end.position))
      return fmt::format("{} lies in structure '{}': say structure = \"{}\"", at, around->name, around->name);
    if (const Lining* const around = lining_around(scene, end.position))
      return fmt::format("{} lies in the cavity of lining '{}'", at, around->name);
    return in_soil(scene, end.position)
               ? std::string()
               : fmt::format("{} lies in no soil while the prop '{}' stands: move it, or name a structure",
                             at, prop.name);
  }
  const auto found = std::ranges::find(scene.structures, end.structure, &Structure::name);
  if (found == scene.structures.end())
    return fmt::format("the structure '{}' does not stand all the time that the prop '{}' does",
                       end.structure, prop.name);
  if (!contains(found->outline.corners, end.position))
    return fmt::format("{} lies outside structure '{}', to which the prop is fastened", at, found->name);
  if (found->hole && strictly_inside(found->hole->corners, end.position))
    return fmt::format("{} lies in the hole of structure '{}'", at, found->name);
  return {};
}

} // namespace

void props_are_fastened(const Case& scene, Findings& findings) {
  for (const Prop& prop : scene.props) {
    if (!findings.sound(prop.path) || !findings.sound(prop.path + ".from") ||
        !findings.sound(prop.path + ".to"))
      continue;
    if (prop.from.structure == prop.to.structure) {
      findings.add(
          prop.path + ".to",
          prop.from.structure.empty()
              ? fmt::format("both ends of the prop '{}' lie in the ground: one must be fastened to a "
                            "structure",
                            prop.name)
              : fmt::format("both ends of the prop '{}' are fastened to the structure '{}'", prop.name,
                            prop.from.structure));
      continue;
    }
    if (prop.from.position.x == prop.to.position.x && prop.from.position.y == prop.to.position.y)
      findings.add(prop.path + ".to.at",
                   fmt::format("'at' [{:g}, {:g}] is the other end too, must be apart: a prop acts along the "
                               "line between its ends",
                               prop.to.position.x, prop.to.position.y));
    for (const auto& [end, key] : {std::pair{&prop.from, ".from"}, std::pair{&prop.to, ".to"}})
      if (const std::string why = why_loose(scene, prop, *end); !why.empty())
        findings.add(prop.path + key + ".at", why);
  }
}

} // namespace tremolo::scene
