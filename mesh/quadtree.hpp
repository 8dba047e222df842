#pragma once

// A block of square root cells, each the root of a quadtree: the cells of a graded mesh. Cell (l, i, j) has
// the side h_l = h/2^l and its lower left corner at (x0 + i h_l, y0 + j h_l). Leaves that share an edge or a
// corner differ by one level at most (2:1 balance).

#include "mesh/cell_size.hpp"

#include "base/vector.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mesh {

/// An axis-parallel rectangle, m.
struct Rectangle {
  double x_min = 0.0;
  double y_min = 0.0;
  double x_max = 0.0;
  double y_max = 0.0;

  double width() const { return x_max - x_min; }
  double height() const { return y_max - y_min; }
  double area() const { return width() * height(); }
  /// Whether p lies inside or on the edge.
  bool contains(const Vector& p) const {
    return p.x >= x_min && p.x <= x_max && p.y >= y_min && p.y <= y_max;
  }
};

/// A box with cells 2^level times smaller than the root cells.
struct Refinement {
  Rectangle box;
  int level = 0;
};

/// Refinements of a model: those that reach one of its edges go on beyond it without end.
/// @param near   m
/// @param sides  whether the left and the right edge count
std::vector<Refinement> beyond_edges(std::span<const Refinement> refinements, const Rectangle& model,
                                     double near, bool sides);

/// The root cells.
struct Roots {
  double x0 = 0.0; ///< lower left corner, m
  double y0 = 0.0;
  double h = 0.0; ///< side, m
  int nx = 0;     ///< cells in a row
  int ny = 0;     ///< rows
  /// Columns after which the cells repeat themselves, from `first_column` on; 0: they do not.
  int period = 0;
  int first_column = 0;
};

struct Cell {
  int level = 0;
  int i = 0;
  int j = 0;

  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The finest allowed level: cells 1/256 of the root's side.
inline constexpr int finest_level_allowed = 8;

class Quadtree {
public:
  /// Cuts every cell that overlaps a refinement's box until the level is reached, then more cells until the
  /// balance holds.
  /// @throws std::invalid_argument for a root block without cells or a level out of 0 to finest_level_allowed
  Quadtree(const Roots& roots, std::span<const Refinement> refinements);

  const Roots& roots() const { return roots_; }
  /// The finest level that has leaves.
  int finest() const { return static_cast<int>(cut_.size()); }
  double size(int level) const { return cell_size(roots_.h, level); }
  Rectangle rectangle(const Cell& cell) const;

  /// False beyond the roots.
  bool exists(const Cell& cell) const;
  bool is_cut(const Cell& cell) const;
  bool is_leaf(const Cell& cell) const { return exists(cell) && !is_cut(cell); }
  /// Level by level, row by row; images of a period included.
  std::vector<Cell> leaves() const;
  /// The finest leaf level that overlaps a rectangle; 0 where there is none.
  int finest_in(const Rectangle& rectangle) const;
  /// The coarsest one; the finest level where there is none.
  int coarsest_in(const Rectangle& rectangle) const;

  /// Cells that were cut for the balance alone, by their level.
  const std::vector<std::size_t>& cut_for_balance() const { return cut_for_balance_; }

private:
  int columns(int level) const { return roots_.nx << level; }
  int rows(int level) const { return roots_.ny << level; }
  int real_column(int level, int i) const;
  /// Place of a cell in cut_[level]; npos beyond the roots.
  std::size_t place(const Cell& cell) const;
  bool has_leaf_in(int level, const Rectangle& rectangle) const;
  void refine(const Refinement& refinement);
  void balance();

  Roots roots_;
  std::vector<std::vector<std::uint8_t>> cut_; ///< [level][row, column]: the cell has children
  std::vector<std::size_t> cut_for_balance_;
};

} // namespace tremolo::mesh
