#pragma once

#include "mpm_domain/kernel/kernel.hpp"
#include "mpm_domain/particles/particles.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tremolo::mpm_domain {

/// The boxes of a set whose particles keep their size: squares no wider than a cell, which touch three rows.
class OneSquare {
public:
  static constexpr std::size_t rows = 3;
  static constexpr bool follow = false; ///< whether boxes follow the soil

  /// @param axis  of either direction: cells are squares
  OneSquare(const Particles& p, const Lattice&, const Axis& axis) : side_(p.half_size, axis) {}

  /// The boxes of a group of particles from k on.
  template <typename Group>
  const OneSquare& of(std::size_t, Group) const {
    return *this;
  }

  /// The first row of particles at `row` rows from row 0 of the lattice.
  Lanes first_row(const Lanes& row) const { return floor(row - side_.l); }
  CellWeights<Lanes> along_x(const Lanes& xi, const Axis& axis) const { return {xi, axis, side_}; }
  RowWeights<Lanes> along_y(const Lanes& eta, const Axis& axis) const { return {eta, axis, side_}; }

private:
  HalfSide<double> side_;
};

/// The boxes of four particles, a rectangle each, up to two cells wide: four rows.
struct Rectangles {
  HalfSide<Lanes> x, y;

  Lanes first_row(const Lanes& row) const { return floor(row) - 1.0; }
  CellWeights<Lanes> along_x(const Lanes& xi, const Axis& axis) const { return {xi, axis, x}; }
  CellWeights<Lanes> along_y(const Lanes& eta, const Axis& axis) const { return {eta - 1.0, axis, y}; }
};

/// The boxes of a set that follow the soil.
class OwnRectangles {
public:
  static constexpr std::size_t rows = 4;
  static constexpr bool follow = true; ///< whether boxes follow the soil

  OwnRectangles(const Particles& p, const Lattice& lattice, const Axis& axis)
      : p_(p), axis_(axis), limits_(p.box_limits()) {
    limits_.most = std::min(limits_.most, lattice.h); // a box on finer cells, grown since the last sort
  }

  template <typename Group>
  [[gnu::always_inline]] Rectangles of(std::size_t k, Group group) const {
    return {{limits_.half_side(group.load(&p_.box_xx[k])), axis_},
            {limits_.half_side(group.load(&p_.box_yy[k])), axis_}};
  }

private:
  const Particles& p_;
  const Axis& axis_;
  BoxLimits limits_;
};

/// act.template operator()<Boxes>() for the boxes of a set.
template <typename Act>
auto for_boxes(const Particles& p, const Act& act) {
  return p.has_own_boxes() ? act.template operator()<OwnRectangles>() : act.template operator()<OneSquare>();
}

/// Layout of a lattice's nodes in an array: node (i, j) has the index first + j row + i.
struct NodeArray {
  double row;
  double first;

  /// Layout in the arrays of all nodes.
  explicit NodeArray(const Lattice& lattice) : row(lattice.nx), first(static_cast<double>(lattice.first)) {}
  /// Layout in an array that holds a window of the lattice by rows.
  explicit NodeArray(const NodeBlock& window)
      : row(window.columns), first(-static_cast<double>(window.row * window.columns + window.column)) {}
};

/// The nodes of four particles, a lane each: along x the four nodes around the particle's cell, which all
/// particles of the cell share; along y the rows that its box touches. Where there are fewer than four
/// particles, the coordinates in the unused lanes are zero and their results must not be used.
struct Stencils {
  Lanes xi;     ///< cells above node 1 of a row
  Lanes eta;    ///< cells above row 0
  Lanes x0, y0; ///< column and row of the first node

  template <typename Boxes>
  Stencils(const Lanes& x, const Lanes& y, const Axis& x_axis, const Axis& y_axis, const Boxes& boxes) {
    const Lanes column = x_axis.cells(x);
    const Lanes row = y_axis.cells(y);
    x0 = floor(column) - 1.0;
    y0 = boxes.first_row(row);
    xi = column - x0 - 1.0;
    eta = row - y0;
  }

  /// The first node of each particle in an array of nodes.
  std::array<std::int32_t, 4> first_nodes(const NodeArray& nodes) const {
    return truncated(y0 * nodes.row + x0 + nodes.first);
  }

  /// The lower left node of each particle's cell: in row 1 of the stencil, if not in row 0.
  std::array<std::int32_t, 4> cells(const NodeArray& nodes) const {
    const Lanes in_row = choose(eta < 1.0, all(1.0), all(1.0 + nodes.row));
    return truncated(y0 * nodes.row + x0 + nodes.first + in_row);
  }

  static std::array<std::int32_t, 4> truncated(const Lanes& values) {
    std::array<std::int32_t, 4> whole;
    _mm_storeu_si128(reinterpret_cast<__m128i*>(whole.data()), _mm256_cvttpd_epi32(values));
    return whole;
  }
};

} // namespace tremolo::mpm_domain
