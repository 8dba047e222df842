#include "mpm_domain/tiles/cell_means.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

std::size_t CellFinder::leaf_at(double x, double y) const {
  const std::optional<mesh::Cell> cell = mesh_->part_at(x, y);
  if (!cell)
    return 0;
  return mesh_->tree().exists(*cell)
             ? mesh_->node(cell->level, cell->i, cell->j)
             : mesh_->node(cell->level - 1, cell->i / 2, cell->j / 2); // a quarter of one
}

void clear_cells(Ground& ground) {
  // On a mesh all rows: a cell may begin at a node that is tied to finer ones and carries no soil.
  ground.workers.run(ground.mesh ? ground.row_count() : ground.soil_rows.size(), [&](std::size_t row) {
    const auto [begin, end] = ground.mesh ? ground.row(row) : ground.soil_rows[row];
    for_group(ground.grid, NodeGroup::cell,
              [&](NodeField& field) { std::fill(field.data() + begin, field.data() + end, 0.0); });
  });
}

void join_images_of_cells(Ground& ground) {
  fold(ground, NodeGroup::cell, ground.image_rows);
  prolong(ground, NodeGroup::cell, ground.image_rows);
}

} // namespace tremolo::mpm_domain
