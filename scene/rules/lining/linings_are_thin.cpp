// A beam is thin beside the width of its cavity, and that is wide enough for cells to carry the ground around
// it: soil and lining meet in segments of one cell.

#include "scene/plan/structures.hpp"
#include "scene/rules/lining/outlines.hpp"
#include "scene/rules/rules.hpp"
#include "scene/thickness.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

void linings_are_thin(const Case& scene, Findings& findings) {
  if (!mesh_is_sound(scene, findings))
    return;
  constexpr double most = 0.2; // of the width: a ring of t/R = 0.5
  constexpr double cells = 4.0;
  constexpr double rounding = 0.99; // the flats of a circle's polygon lie a little inside it
  const double h = contact_cell_size(scene);
  for (const Lining& lining : scene.linings) {
    if (!outline_is_sound(lining, findings))
      continue;
    const double wide = thickness(lining.outline.corners, {});
    if (findings.sound(lining.path + ".thickness") && lining.thickness > most * wide)
      findings.add(lining.path + ".thickness",
                   fmt::format("'thickness' = {:g} m is too much for a beam around a cavity that is {:.3g} m "
                               "wide, must be at most {:.3g} m: thicker walls are an elastic [[structure]] "
                               "with a hole",
                               lining.thickness, wide, most * wide));
    if (wide < rounding * cells * h)
      findings.add(outline_path(lining),
                   fmt::format("'{}' is {:.3g} m wide at one place, must be at least four cells of {:g} m: "
                               "a lining meets soil in segments of one cell; take smaller cells",
                               lining.outline.key, wide, h));
  }
}

} // namespace tremolo::scene
