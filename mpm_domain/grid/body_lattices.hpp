#pragma once

// Elastic bodies have nodes of their own, so that they may move apart from the soil: a lattice for each,
// behind those of the soil in the arrays of all nodes. Its nodes lie at the positions of nodes of the soil's
// finest lattice, nothing ties them to others, and it follows the body from sort to sort. Soil and body meet
// where both have a node (contact/contact.hpp).

#include "mpm_domain/spec/lattice.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

struct BodyLattice {
  Lattice lattice;
  int column = 0; ///< of its first node, among the nodes of the soil's finest lattice
  int row = 0;

  /// Its node at the place of a node of the soil's finest lattice, if there is one.
  std::optional<std::size_t> node_at(int soil_column, int soil_row) const {
    const int i = soil_column - column;
    const int j = soil_row - row;
    if (i < 0 || i >= lattice.nx || j < 0 || j >= lattice.ny)
      return std::nullopt;
    return lattice.index(i, j);
  }
};

/// Lays the lattices around the particles of the bodies and whatever these may touch until the next sort; the
/// fields of all nodes become zero if a lattice has changed. Lattices are the same on all ranks.
void follow_bodies(Ground& ground);

/// Puts lattices of known size and column and row behind those of the soil, cuts all into tiles, and makes
/// all fields zero.
void lay_out_lattices(Ground& ground);

/// Columns, rows and sizes of the lattices, for a checkpoint, and back.
std::vector<double> lattice_state(const std::vector<BodyLattice>& bodies);
void set_lattice_state(std::vector<BodyLattice>& bodies, const std::vector<double>& state);

} // namespace tremolo::mpm_domain
