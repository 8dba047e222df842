#pragma once

// Soil in shear leans, and its sides with it: a side that has moved by u_x(y) has the normal (n_x, -n_x
// du_x/dy), on which the weight of the soil above acts too, and the water beside it:
//
//     f = -n_x du_x/dy (sigma_xy^ff, sigma_yy),      on water per unit of its volume  n_x du_x/dy p_e.
//
// Left and right this is a couple, the one that ground between leaning neighbours feels. Without it, ground
// that has liquefied and leans would turn for as long as it is shaken, since nothing but dashpots holds it.
// sigma_yy is the total stress over the water at rest.
//
// Rows of particles move as a whole: a side leans in steps, at the edges between its faces, where a row has
// moved by [u_x] more than the one below. Each edge therefore loads the nodes around it, half at the line of
// either face,
//
//     F = -n_x [u_x] (sigma_xy^ff, sigma_yy),
//
// which is to the second order of [u_x] what the soil that would go on beyond the side exerts there. Spread
// along the faces instead, it would reach nodes beyond the lowest row, which the base moves with.

#include "coupler/eq6/boundary_traction.hpp"
#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/boundary/near/near_faces.hpp"
#include "mpm_domain/ranks/exact_sum.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Forces of an edge between two faces of a side on the nodes around it.
struct LeaningEdge {
  Vector on_soil;        ///< on soil and water together, N/m
  double on_water = 0.0; ///< upwards, on water per unit of its volume, N/m
};

class LeaningSides {
public:
  /// Finds the loads of the edges of sides that are not tied to each other.
  /// @param near        the faces that are worked out here: edges between two of them
  /// @param soil,field  one a face
  void find(const Ground& ground, std::span<const BoundaryFace> faces, const NearFaces& near,
            std::span<const FaceSoil> soil, std::span<const eq6::FreeField> field);

  std::span<const LeaningEdge> edges() const { return edges_; }
  /// Each node's share of an edge's load; a node may stand twice.
  std::span<const FaceWeights> weights() const { return weights_; }
  /// Work of the loads on soil with the mean of velocities before and after the last update, J/m, that counts
  /// on this rank: that of edges above faces whose particles it has.
  /// @param kick  time that they have acted for, s
  ExactSum work(const Grid& grid, double kick) const;

private:
  std::vector<LeaningEdge> edges_;
  std::vector<FaceWeights> weights_;
  std::vector<bool> counts_; ///< by edge
};

} // namespace tremolo::mpm_domain
