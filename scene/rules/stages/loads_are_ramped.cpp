// A load that comes faster than the ground swings makes it swing: half a cosine as long as n periods leaves
// 1/(4 n^2 - 1) of the static deformation, 1 % at n = 5. Soil yields on the way to it.

#include "scene/plan/stages/stages.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void loads_are_ramped(const Case& scene, Findings& findings) {
  for (const LoadStage& load : scene.loads)
    if (const double least = slow_ramp(scene); load.ramp && *load.ramp < (1.0 - 1e-9) * least)
      findings.add(load.path + ".ramp_s",
                   fmt::format("the load '{}' comes within {:g} s, less than five periods 4 H/c_s of the "
                               "ground, {:.3g} s: soil may yield where the ground overshoots; without "
                               "'ramp_s' it takes as long as that",
                               load.name, *load.ramp, least));
}

} // namespace tremolo::scene
