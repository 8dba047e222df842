#pragma once

// Where the boundary of the domain stands before soil whose water flows, no water passes: w . n = 0. The
// nodes on a face's line, and those next to it outside, are closed. Where the line lies within a cell, the
// nodes on its inner side are open. They feel the force of the excess pressure in the soil up to the line, f
// = sum V p_e grad S, and need the reaction of the wall there,
//
//     f_i -= sum over faces 2l W_i p_e n,
//
// with the weights W of the boundary (boundary_faces.hpp), whose tractions balance a uniform stress exactly.
// Without it, a pressure beside the line would drive water out through the nodes until it had fallen to the
// share of the cell that the soil fills.

#include "mpm_domain/ground.hpp"

#include <vector>

namespace tremolo::mpm_domain {

class Boundary;

/// Walls on the flow of water during one update of the nodes.
class ImperviousFaces {
public:
  /// Closes the nodes of the faces, and adds the reactions of the walls to the forces on water.
  void close(Ground& ground, const Boundary& boundary);
  /// Takes the reactions off the forces again, which are those of the pressure in the soil alone from then
  /// on.
  /// @returns power that they had on the flow n w, W/m, which the update has booked as dissipated by drag
  double open(Ground& ground);

private:
  struct Reaction {
    std::size_t node;
    Vector force; ///< N/m
  };
  std::vector<Reaction> reactions_;
};

} // namespace tremolo::mpm_domain
