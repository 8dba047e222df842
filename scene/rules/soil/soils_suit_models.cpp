#include "scene/plan/layers.hpp"
#include "scene/rules/free_field_limits.hpp"
#include "scene/rules/rules.hpp"

#include <string>

namespace tremolo::scene {

void soils_suit_models(const Case& scene, Findings& findings) {
  const auto check = [&](SourceModel model, const LateralBoundary& side, const std::string& path) {
    if (const auto why = refused_soil(scene, model, layers(scene, side));
        !why.empty() && findings.sound(path))
      findings.add(path, why + other_ways(scene, model, side.surface, layers(scene, side)));
  };
  const auto& [sides, left, right, base] = scene.boundary;
  if (scene.boundary.has_lateral_fields()) {
    check(left.field.model, left, "boundary.left.model");
    check(right.field.model, right, "boundary.right.model");
  }
  check(base.field.model, left, "boundary.base.model");
}

} // namespace tremolo::scene
