#pragma once

// Weights of a particle of any size, also across levels: the basis N averaged over the particle's box,
//
//     S = 1/|B| int_B N dA,      G = 1/|B| int_B grad N dA.
//
// N is bilinear on every part R of the box that lies in one cell, and the mean of a bilinear function and of
// its gradient over a rectangle is their value at its centroid x_R, so both are exact as
//
//     S = sum_R |R|/|B| N(x_R),      G = sum_R |R|/|B| grad N(x_R).
//
// Where N is the hat function of a uniform grid, these are the weights of uGIMP.

#include "mpm_domain/grid/graded_mesh.hpp"

#include <vector>

namespace tremolo::mpm_domain {

/// A node of a lattice, tied or real, and its weights. A node may stand several times in a list.
struct BoxWeight {
  std::size_t node = 0;
  double x = 0.0; ///< where it lies, m
  double y = 0.0;
  double s = 0.0;
  double gx = 0.0; ///< 1/m
  double gy = 0.0;
};

/// Adds the weights of a box to a list. A box without width or height gives the means along the line or at
/// the point; what lies beyond the mesh is left out.
void box_average(const GradedMesh& mesh, const mesh::Rectangle& box, std::vector<BoxWeight>& weights);

/// D of a particle's weights about the middle of its box, m2. It is diagonal across lattices too: over the
/// parts R of a box, sum |R| (x_R - x)(y_R - y) = int (x - x_p)(y - y_p) dA = 0; and the nodes that a virtual
/// one follows lie about it symmetrically in x or in y.
struct SecondMoments {
  double x = 0.0;
  double y = 0.0;
};
SecondMoments second_moments(const GradedMesh& mesh, const mesh::Rectangle& box);

} // namespace tremolo::mpm_domain
