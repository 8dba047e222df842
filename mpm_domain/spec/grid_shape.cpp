#include "mpm_domain/spec/grid_shape.hpp"

#include "mesh/cell_size.hpp"
#include "mpm_domain/spec/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

/// Empty nodes around a level's cells, for kernels that read whole rows of four nodes.
constexpr int padding = 2;

/// Columns and rows of the cells of a level, leaves and quarters.
struct Extent {
  int i_min = std::numeric_limits<int>::max();
  int j_min = std::numeric_limits<int>::max();
  int i_max = std::numeric_limits<int>::min();
  int j_max = std::numeric_limits<int>::min();

  void take(int i0, int j0, int i1, int j1) {
    i_min = std::min(i_min, i0);
    j_min = std::min(j_min, j0);
    i_max = std::max(i_max, i1);
    j_max = std::max(j_max, j1);
  }
};

} // namespace

GridShape grid_shape(const mesh::Rectangle& box, double cell_size, Sides sides) {
  const auto nodes = [&](double length) {
    return static_cast<int>(std::ceil(length / cell_size - 1e-9)) + 1 + 2 * margin_cells;
  };
  GridShape grid;
  grid.h = cell_size;
  grid.x0 = box.x_min - margin_cells * cell_size;
  grid.y0 = box.y_min - margin_cells * cell_size;
  grid.nx = nodes(box.x_max - box.x_min);
  grid.ny = nodes(box.y_max - box.y_min);
  if (sides == Sides::periodic) {
    grid.period = static_cast<int>(std::lround((box.x_max - box.x_min) / cell_size));
    grid.first_column = margin_cells;
  }
  return grid;
}

mesh::Roots roots_of(const GridShape& grid) {
  return {grid.x0, grid.y0, grid.h, grid.nx - 1, grid.ny - 1, grid.period, grid.first_column};
}

std::vector<mesh::Refinement> refinements_of(std::span<const mesh::Refinement> refine,
                                             const mesh::Rectangle& box, double cell_size, Sides sides) {
  return mesh::beyond_edges(refine, box, mesh::alignment_tolerance(cell_size), sides != Sides::periodic);
}

bool is_split(const mesh::Quadtree& tree, const mesh::Cell& leaf) {
  return tree.is_cut({leaf.level, leaf.i - 1, leaf.j}) || tree.is_cut({leaf.level, leaf.i + 1, leaf.j}) ||
         tree.is_cut({leaf.level, leaf.i, leaf.j - 1}) || tree.is_cut({leaf.level, leaf.i, leaf.j + 1});
}

std::vector<LevelLattice> lattices_of(const mesh::Quadtree& tree) {
  const mesh::Roots& roots = tree.roots();
  std::vector<Extent> extents(static_cast<std::size_t>(tree.finest()) + 1);
  for (const mesh::Cell& leaf : tree.leaves()) {
    const auto level = static_cast<std::size_t>(leaf.level);
    extents[level].take(leaf.i, leaf.j, leaf.i, leaf.j);
    if (is_split(tree, leaf))
      extents[level + 1].take(2 * leaf.i, 2 * leaf.j, 2 * leaf.i + 1, 2 * leaf.j + 1);
  }
  extents.front() = {padding, padding, roots.nx - 1 - padding, roots.ny - 1 - padding};
  std::vector<LevelLattice> lattices;
  std::size_t first = 0;
  for (std::size_t level = 0; level < extents.size(); ++level) {
    const Extent& extent = extents[level];
    const double h = tree.size(static_cast<int>(level));
    LevelLattice& one = lattices.emplace_back();
    one.origin_i = extent.i_min - padding;
    one.origin_j = extent.j_min - padding;
    one.lattice = {h,
                   roots.x0 + one.origin_i * h,
                   roots.y0 + one.origin_j * h,
                   extent.i_max - extent.i_min + 2 + 2 * padding,
                   extent.j_max - extent.j_min + 2 + 2 * padding,
                   first};
    first += one.lattice.count();
  }
  return lattices;
}

} // namespace tremolo::mpm_domain
