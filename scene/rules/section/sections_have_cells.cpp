// A bending member needs about four cells over its thickness (docs/structures.md).

#include "scene/plan/section/section_cuts.hpp"
#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

void sections_have_cells(const Case& scene, Findings& findings) {
  constexpr double enough = 4.0;
  constexpr double rounding = 1e-6; // a polygon of a circle is a little thinner than the circle
  const double h = contact_cell_size(scene);
  for (const Section& section : scene.sections) {
    const std::vector<SectionCut> cuts = cuts_of(scene, section);
    const double thinnest =
        std::ranges::min(cuts, {}, [](const SectionCut& cut) { return cut.thickness(); }).thickness();
    if (thinnest < (enough - rounding) * h)
      findings.add(
          line_path(section),
          fmt::format("the cut is {:.3g} m long, {:.3g} cells of {:g} m: what bends needs about four "
                      "cells over its thickness; take smaller cells, or a [[lining]]",
                      thinnest, thinnest / h, h));
  }
}

} // namespace tremolo::scene
