#pragma once

#include "mesh/cell_size.hpp"
#include "mpm_domain/spec/lattice.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

/// Degrees of freedom of a node that a rough base and smooth side walls fix.
enum class Hold {
  none,
  across, ///< u_x = 0: the node may slide along a side
  all,    ///< at the base
};

/// The nodes that are held: those on the lines of base and sides only, or also those behind them.
enum class HeldNodes { on_lines, on_and_behind };

/// The fixity of a node (column, row) of a lattice by the model's base and, unless they are periodic, its
/// sides.
inline Hold hold_of(const Lattice& lattice, int column, int row, const Spec& spec, HeldNodes which) {
  const double near = mesh::alignment_tolerance(lattice.h);
  const auto is_held = [&](double behind) { // m behind a line
    return which == HeldNodes::on_lines ? std::abs(behind) < near : behind > -near;
  };
  if (is_held(spec.box.y_min - (lattice.y0 + row * lattice.h)))
    return Hold::all;
  const double x = lattice.x0 + column * lattice.h;
  const bool side = !spec.periodic() && (is_held(spec.box.x_min - x) || is_held(x - spec.box.x_max));
  return side ? Hold::across : Hold::none;
}

} // namespace tremolo::mpm_domain
