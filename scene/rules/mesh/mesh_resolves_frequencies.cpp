#include "scene/plan/levels.hpp"
#include "scene/plan/wave/resolution.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void mesh_resolves_frequencies(const Case& scene, Findings& findings) {
  const auto resolved_by = [&](double cell_size) { return resolved_frequency(scene, cell_size); };
  findings.add("mesh.size",
               fmt::format("shear waves up to {:.3g} Hz have {} cells per wavelength or more (speed "
                           "error below about 2 % with apic, 3.5 % with flip)",
                           resolved_by(scene.mesh.size), cells_per_wavelength));
  if (scene.mesh.refine.empty())
    return;
  if (const auto all = levels(scene); all.size() > 1)
    findings.add("mesh.size", fmt::format("level by level these are, in Hz: {}", by_level(all, resolved_by)));
}

} // namespace tremolo::scene
