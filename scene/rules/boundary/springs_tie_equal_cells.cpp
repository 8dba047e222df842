#include "mesh/cell_size.hpp"
#include "scene/plan/levels.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tremolo::scene {

namespace {

struct SideCell {
  double y_min = 0.0; ///< m
  double size = 0.0;  ///< m
  friend bool operator==(const SideCell&, const SideCell&) = default;
};

/// The cells with soil along the left or the right edge of the model, from the bottom up.
std::vector<SideCell> cells_along(const mesh::Quadtree& tree, const Box& model, bool right, double surface) {
  const double tolerance = mesh::alignment_tolerance(tree.size(0));
  const double edge = right ? model.x_max : model.x_min;
  std::vector<SideCell> cells;
  for (const mesh::Cell& leaf : tree.leaves()) {
    const mesh::Rectangle box = tree.rectangle(leaf);
    const double side = right ? box.x_max : box.x_min;
    if (std::abs(side - edge) < tolerance && box.y_min > model.y_min - tolerance && box.y_min < surface)
      cells.push_back({box.y_min, tree.size(leaf.level)});
  }
  std::ranges::sort(cells, {}, &SideCell::y_min);
  return cells;
}

} // namespace

void springs_tie_equal_cells(const Case& scene, Findings& findings) {
  if (scene.boundary.sides != Sides::periodic_springs || scene.mesh.refine.empty() ||
      !findings.sound("boundary.sides") || !findings.sound("refine") || !mesh_is_sound(scene, findings))
    return;
  const mesh::Quadtree tree = quadtree(scene);
  const double surface = scene.boundary.left.surface - mesh::alignment_tolerance(scene.mesh.size);
  const std::vector<SideCell> left = cells_along(tree, scene.mesh.box, false, surface);
  const std::vector<SideCell> right = cells_along(tree, scene.mesh.box, true, surface);
  const auto [one, other] = std::ranges::mismatch(left, right);
  if (one != left.end() && other != right.end())
    findings.add("boundary.sides",
                 fmt::format("sides = \"periodic_springs\" tie particles of the left side to those of the "
                             "right, but from y = {} on cells are {} m at the left and {} m at the right; "
                             "refine both sides alike, or use sides = \"periodic\"",
                             one->y_min, one->size, other->size));
}

} // namespace tremolo::scene
