#pragma once

#include "mpm_domain/spec/lattice.hpp"
#include "mpm_domain/spec/spec.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

/// What a rough base and smooth side walls leave of the motion of a node.
enum class Hold {
  none,
  across, ///< u_x = 0: the node may slide along a side
  all,    ///< at the base, or below it
};

/// How a node (column, row) of a lattice is held by the model's base and, unless they are periodic, its
/// sides.
inline Hold hold_of(const Lattice& lattice, int column, int row, const Spec& spec) {
  const double near = 1e-6 * lattice.h;
  if (lattice.y0 + row * lattice.h < spec.box.y_min + near)
    return Hold::all;
  const double x = lattice.x0 + column * lattice.h;
  const bool side = !spec.periodic() && (x < spec.box.x_min + near || x > spec.box.x_max - near);
  return side ? Hold::across : Hold::none;
}

} // namespace tremolo::mpm_domain
