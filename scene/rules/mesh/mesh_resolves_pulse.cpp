#include "scene/plan/wave/resolution.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void mesh_resolves_pulse(const Case& scene, Findings& findings) {
  for (const MotionInput* wave : scene.plane_waves())
    for (const ShakingMotion& shaking : wave->shakings) {
      const auto* pulse = std::get_if<RickerPulse>(&shaking.source);
      if (pulse == nullptr)
        continue;
      const double highest = 2.5 * pulse->frequency; // the spectrum of a Ricker pulse is at 3 % of its peak
      if (highest > resolved_frequency(scene, scene.mesh.size))
        findings.add(
            shaking.path + ".pulse",
            fmt::format("the pulse reaches up to about {:.3g} Hz: the mesh is coarse for it", highest));
    }
}

} // namespace tremolo::scene
