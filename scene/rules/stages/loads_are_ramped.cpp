// A load that comes faster than the ground swings makes it swing: half a cosine as long as n periods leaves
// 1/(4 n^2 - 1) of the static deformation, 1 % at n = 5. Soil yields on the way to it. What is placed and
// removed is a load of the same kind.

#include "scene/plan/stages/stages.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void loads_are_ramped(const Case& scene, Findings& findings) {
  const double least = slow_ramp(scene);
  const auto look = [&](const auto& stage, double ramp, const char* what, const char* remedy) {
    if (ramp < (1.0 - 1e-9) * least)
      findings.add(stage.path + ".ramp_s",
                   fmt::format("the {} '{}' comes within {:g} s, less than five periods 4 H/c_s of the "
                               "ground, {:.3g} s: soil may yield where the ground overshoots; {}",
                               what, stage.name, ramp, least, remedy));
  };
  const char* const without = "without 'ramp_s' it takes as long as that";
  const char* const longer = "take as long as that";
  for (const LoadStage& load : scene.loads)
    look(load, ramp_of(scene, load), "load", load.start ? longer : without);
  for (const ConstructionStage& construction : scene.constructions)
    look(construction, ramp_of(scene, construction),
         construction.water ? "change of the water" : "construction", without);
  for (const Earthwork& work : scene.earthworks)
    look(work, work.ramp, "construction", longer);
}

} // namespace tremolo::scene
