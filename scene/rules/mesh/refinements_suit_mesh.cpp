#include "mesh/cell_size.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::scene {

namespace {

/// Limit on the cells if the whole model had the finest size; the tree's memory grows with their number.
constexpr double most_cells = 1e9;

bool overlap(const Box& a, const Box& b) {
  return std::max(a.x_min, b.x_min) < std::min(a.x_max, b.x_max) &&
         std::max(a.y_min, b.y_min) < std::min(a.y_max, b.y_max);
}

} // namespace

void refinements_suit_mesh(const Case& scene, Findings& findings) {
  const Mesh& mesh = scene.mesh;
  for (std::size_t i = 0; i < mesh.refine.size(); ++i) {
    const std::string path = fmt::format("refine[{}]", i);
    const auto& [box, level] = mesh.refine[i];
    if (findings.sound(path + ".box") && (!(box.width() > 0.0) || !(box.height() > 0.0)))
      findings.add(
          path + ".box",
          fmt::format("'box' is {} m wide and {} m high, must be [x_min, y_min, x_max, y_max] with both > 0",
                      box.width(), box.height()));
    if (!findings.sound("mesh.box") || !findings.sound("mesh.size"))
      continue;
    if (findings.sound(path + ".box") && !overlap(box, mesh.box))
      findings.add(path + ".box",
                   fmt::format("'box' lies beside the mesh, x {} to {} and y {} to {}: nothing is refined",
                               mesh.box.x_min, mesh.box.x_max, mesh.box.y_min, mesh.box.y_max));
    const double size = mesh::cell_size(mesh.size, level);
    const double cells = mesh.box.width() / size * (mesh.box.height() / size);
    if (findings.sound(path + ".level") && !(cells <= most_cells))
      findings.add(
          path + ".level",
          fmt::format("'level' = {} makes cells of {} m, of which the model would hold {:.3g}, must be "
                      "at most {:g}",
                      level, size, cells, most_cells));
  }
}

} // namespace tremolo::scene
