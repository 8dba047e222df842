#include "mpm_domain/transfer/cell_means.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

/// The lower left node of the leaf that holds a point.
std::size_t leaf_at(const GradedMesh& mesh, double x, double y) {
  std::size_t node = 0;
  mesh.for_parts({x, y, x, y}, [&](const mesh::Cell& cell, const mesh::Rectangle&) {
    const bool is_leaf = mesh.tree().exists(cell);
    node = is_leaf ? mesh.node(cell.level, cell.i, cell.j)
                   : mesh.node(cell.level - 1, cell.i / 2, cell.j / 2); // a quarter of one
  });
  return node;
}

} // namespace

CellFinder::Cell CellFinder::at(double x, double y) const {
  if (mesh_ != nullptr)
    return {leaf_at(*mesh_, x, y), 0};
  const int column = static_cast<int>(std::floor((x - lattice_->x0) / lattice_->h));
  const int row = static_cast<int>(std::floor((y - lattice_->y0) / lattice_->h));
  return {lattice_->index(column, row),
          static_cast<std::size_t>((row - place_.row) * window_columns + column - place_.column)};
}

void clear_cells(Domain& domain) {
  // All rows: a cell may begin at a node that is tied to finer ones and carries no soil.
  domain.workers.run(domain.row_count(), [&](std::size_t row) {
    const auto [begin, end] = domain.row(row);
    for_group(domain.grid, NodeGroup::cell,
              [&](NodeField& field) { std::fill(field.data() + begin, field.data() + end, 0.0); });
  });
}

void join_images_of_cells(Domain& domain) {
  fold(domain, NodeGroup::cell, domain.image_rows);
  prolong(domain, NodeGroup::cell, domain.image_rows);
}

} // namespace tremolo::mpm_domain
