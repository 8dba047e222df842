#include "scene/meeting_boxes.hpp"
#include "scene/plan/levels.hpp"
#include "scene/plan/structures.hpp"
#include "scene/rules/rules.hpp"
#include "scene/rules/structure/outlines.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

/// Whether all cells within a margin of a polygon's edges are of the finest level.
/// @param top  where the mesh ends, m
bool is_on_finest(const Polygon& polygon, const mesh::Quadtree& tree, double top, double margin) {
  bool finest = true;
  for_pieces(polygon, top + margin, margin, [&](Point from, Point to) {
    const Box box = box_of({from, to});
    finest = finest && tree.coarsest_in({box.x_min - margin, box.y_min - margin, box.x_max + margin,
                                         box.y_max + margin}) == tree.finest();
  });
  return finest;
}

} // namespace

void structures_lie_on_finest_level(const Case& scene, Findings& findings) {
  if (scene.structures.empty() || scene.mesh.refine.empty() || !mesh_is_sound(scene, findings))
    return;
  const mesh::Quadtree tree = quadtree(scene);
  const double h = tree.size(tree.finest());
  constexpr double rounding = 1e-6;
  const double margin = 2.0 * h;
  for (std::size_t i = 0; i < scene.structures.size(); ++i) {
    if (!outline_is_sound(scene, i, findings))
      continue;
    const Outline& outline = scene.structures[i].outline;
    if (is_on_finest(outline.corners, tree, scene.mesh.box.y_max, (1.0 - rounding) * margin))
      continue;
    const Box box = box_of(outline.corners);
    findings.add(
        outline_path(scene, i),
        fmt::format("'{}' lies within two cells of cells larger than the finest, {:g} m, on which structures "
                    "meet soil; add [[refine]] with level = {} and box = [{:.6g}, {:.6g}, {:.6g}, {:.6g}]",
                    outline.key, h, tree.finest(), box.x_min - margin, box.y_min - margin, box.x_max + margin,
                    box.y_max + margin));
  }
}

} // namespace tremolo::scene
