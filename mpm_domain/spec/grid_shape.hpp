#pragma once

// The cells and nodes of a model, on which the domain is built and which a plan counts.

#include "mesh/quadtree.hpp"
#include "mpm_domain/spec/lattice.hpp"
#include "mpm_domain/spec/numerics.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// The coarsest nodes of a model at the start, with room around its box for soil that moves out of it.
struct GridShape : Lattice {
  /// Columns after which the grid repeats itself, from column `first_column` on; 0: it does not.
  int period = 0;
  int first_column = 0;
};

/// @param box of the model, m
/// @param cell_size of the coarsest cells, m
GridShape grid_shape(const mesh::Rectangle& box, double cell_size, Sides sides);

/// The cells between the nodes of a grid.
mesh::Roots roots_of(const GridShape& grid);

/// Refinements of a model as its mesh takes them: those that reach an edge with faces, or the surface, go on
/// beyond it.
std::vector<mesh::Refinement> refinements_of(std::span<const mesh::Refinement> refine,
                                             const mesh::Rectangle& box, double cell_size, Sides sides);

/// Whether a leaf has a hanging node on an edge and is therefore virtually split.
bool is_split(const mesh::Quadtree& tree, const mesh::Cell& leaf);

/// A lattice of a graded mesh, and the column and row of cells of its level that its first node belongs to.
struct LevelLattice {
  Lattice lattice;
  int origin_i = 0;
  int origin_j = 0;
};

/// The lattices by level: lattice l has the cells of level l, leaves and quarters of split ones. Its block of
/// nodes encloses them; blocks follow one another.
std::vector<LevelLattice> lattices_of(const mesh::Quadtree& tree);

} // namespace tremolo::mpm_domain
