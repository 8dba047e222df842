#include "scene/rules/rules.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void sections_cut_elastic_structures(const Case& scene, Findings& findings) {
  for (const Section& section : scene.sections) {
    if (!section.structure)
      continue;
    const Structure& structure = scene.structures[*section.structure];
    if (!structure.stiffness && findings.sound(structure.path))
      findings.add(
          section.path + ".structure",
          fmt::format("structure '{}' is rigid, and no stress is computed in it: give it 'young' and "
                      "'poisson' in place of 'rigid'",
                      structure.name));
  }
}

} // namespace tremolo::scene
