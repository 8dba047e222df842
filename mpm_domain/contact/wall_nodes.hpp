#pragma once

// The surface of a body as the nodes of a lattice see it: with N_I the bilinear hat of node I,
//
//     L_I = surface integral of N_I,
//
// which is exact: the surface is cut where it crosses the lattice, and along each piece N_I is a polynomial
// of second degree, for which Simpson's rule holds.

#include "mpm_domain/contact/body_surface.hpp"
#include "mpm_domain/spec/lattice.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// Columns [i0, i0 + columns) and rows [j0, j0 + rows) of a lattice.
struct NodeWindow {
  int i0 = 0;
  int j0 = 0;
  int columns = 0;
  int rows = 0;

  std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  bool has(int i, int j) const { return i >= i0 && i < i0 + columns && j >= j0 && j < j0 + rows; }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j - j0) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(i - i0);
  }
};

/// The nodes of a lattice within two cells of a rectangle, as far as there are any.
NodeWindow nodes_around(const Lattice& lattice, const mesh::Rectangle& box);

/// L_I of the nodes of a window, m.
void find_wall(const BodySurface& surface, const Lattice& lattice, const NodeWindow& window,
               std::vector<double>& lengths);

} // namespace tremolo::mpm_domain
