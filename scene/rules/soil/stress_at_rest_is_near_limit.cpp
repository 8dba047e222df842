#include "scene/rules/rules.hpp"
#include "scene/soils/stress_at_rest.hpp"

namespace tremolo::scene {

void stress_at_rest_is_near_limit(const Case& scene, Findings& findings) {
  constexpr double near = 0.9; // of the strength
  if (!scene.gravity)
    return;
  for (const RestingSoil& resting : resting_soils(scene, columns_at_rest(scene)))
    if (resting.is_given && resting.mobilised > near)
      findings.add(rest_path(scene, resting),
                   "'rest_coefficient' is close to the limit of the strength: " + text(scene, resting));
}

} // namespace tremolo::scene
