#pragma once

// The conforming bilinear basis of a graded mesh.
//
// A node of a fine leaf that lies at the middle of a coarse leaf's edge is hanging; it keeps its degrees of
// freedom. Every coarse leaf with a hanging node is virtually split into four quarters. Corners of the
// quarters that are no real nodes are virtual and tied: the middle of an edge to the mean of the edge's ends,
// the centre to the mean of the two mid-edges along the axis that carries hanging nodes, or of all four where
// both axes do. On every leaf that is not split and on every quarter the basis is bilinear.
//
//     fine | coarse           h  hanging node
//    +--+--+--+--+            v  virtual node, v = (a + b)/2
//    |  |  |  :  |            c  centre,       c = (h + v)/2
//    +--+--h..c..v
//    |  |  |  :  |
//    +--+--+--+--+
//
// Leaves and quarters of one size form the cells of one lattice, so that a particle whose box touches cells
// of one lattice alone sees a uniform grid: its weights are the tensor products of uGIMP. All that joins the
// lattices is the prolongation P: besides virtual nodes, it ties a node that stands in several lattices to
// one of them.
//
// After Ma, Lu and Komanduri (2006), "Structured mesh refinement in generalized interpolation material point
// method", and Gao, Tampubolon, Jiang and Sifakis (2017), "An adaptive generalized interpolation material
// point method for simulating elastoplastic materials".

#include "mesh/quadtree.hpp"
#include "mpm_domain/grid/prolongation.hpp"
#include "mpm_domain/spec/grid_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

class GradedMesh {
public:
  /// @throws std::invalid_argument as mesh::Quadtree does
  GradedMesh(const mesh::Roots& roots, std::span<const mesh::Refinement> refinements);

  const mesh::Quadtree& tree() const { return tree_; }
  /// The lattices by level: lattice l has the cells of level l, and its block of nodes encloses them.
  const std::vector<Lattice>& lattices() const { return lattices_; }
  std::size_t node_count() const { return node_count_; }
  const Prolongation& prolongation() const { return prolongation_; }

  /// Calls act(cell, part) for every leaf that is not split and every quarter that a box overlaps, with the
  /// part that lies in it. A box without width or height belongs to the cell to its right or above it. What
  /// lies beyond the roots is left out.
  template <typename Act>
  void for_parts(const mesh::Rectangle& box, const Act& act) const {
    const mesh::Roots& roots = tree_.roots();
    const auto cell = [&](double x, double x0) { return static_cast<int>(std::floor((x - x0) / roots.h)); };
    const double rounding = 1e-9 * roots.h;
    for (int j = cell(box.y_min - rounding, roots.y0); j <= cell(box.y_max + rounding, roots.y0); ++j)
      for (int i = cell(box.x_min - rounding, roots.x0); i <= cell(box.x_max + rounding, roots.x0); ++i)
        if (tree_.exists({0, i, j}))
          for_parts_in({0, i, j}, box, act);
  }

  /// The leaf that is not split, or the quarter, that holds a point, as for_parts() finds it; none beyond the
  /// roots.
  std::optional<mesh::Cell> part_at(double x, double y) const;

  /// Levels of the cells that a box touches, and whether there is a quarter of a split leaf among them.
  struct Touched {
    int coarsest = std::numeric_limits<int>::max();
    int finest = -1;
    bool quarter = false;

    /// Cells of one lattice and no quarter: the box sees a uniform grid of real nodes or single copies of
    /// them.
    bool one_lattice() const { return coarsest == finest && !quarter; }
  };
  Touched touched(const mesh::Rectangle& box) const {
    Touched levels;
    for_parts(box, [&](const mesh::Cell& cell, const mesh::Rectangle&) {
      levels = {std::min(levels.coarsest, cell.level), std::max(levels.finest, cell.level),
                levels.quarter || !tree_.exists(cell)};
    });
    return levels;
  }

  /// Place of a node of a lattice in the arrays of all nodes.
  std::size_t node(int level, int i, int j) const {
    const Lattice& lattice = lattices_[static_cast<std::size_t>(level)];
    return lattice.index(i - origin_i_[static_cast<std::size_t>(level)],
                         j - origin_j_[static_cast<std::size_t>(level)]);
  }

private:
  template <typename Act>
  void for_parts_in(const mesh::Cell& cell, const mesh::Rectangle& box, const Act& act) const {
    const mesh::Rectangle all = tree_.rectangle(cell);
    const mesh::Rectangle part{std::max(all.x_min, box.x_min), std::max(all.y_min, box.y_min),
                               std::min(all.x_max, box.x_max), std::min(all.y_max, box.y_max)};
    const bool in_columns =
        box.x_min < box.x_max ? part.x_min < part.x_max : all.x_min <= box.x_min && box.x_min < all.x_max;
    const bool in_rows =
        box.y_min < box.y_max ? part.y_min < part.y_max : all.y_min <= box.y_min && box.y_min < all.y_max;
    if (!in_columns || !in_rows)
      return;
    const bool whole = !tree_.exists(cell) || (!tree_.is_cut(cell) && !is_split(tree_, cell));
    if (whole)
      return act(cell, part);
    for (int quarter = 0; quarter < 4; ++quarter)
      for_parts_in({cell.level + 1, 2 * cell.i + quarter % 2, 2 * cell.j + quarter / 2}, box, act);
  }

  mesh::Quadtree tree_;
  std::vector<Lattice> lattices_;
  std::vector<int> origin_i_, origin_j_; ///< cell (l, i, j) of the tree has its corner at node (i - origin)
  std::size_t node_count_ = 0;
  Prolongation prolongation_;
};

} // namespace tremolo::mpm_domain
