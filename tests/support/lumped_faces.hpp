#pragma once

// What faces give to the nodes, put together by the test itself.

#include "mpm_domain/domain.hpp"

#include <vector>

namespace tremolo::test_support {

/// Adds to the nodes the tractions of the faces and their dashpots, lumped.
/// @param traction_on (face) -> Pa
template <typename TractionOn>
void add_lumped_faces(mpm_domain::Domain& domain, const TractionOn& traction_on) {
  mpm_domain::Grid& grid = domain.grid;
  mpm_domain::FaceWeights weights;
  for (const mpm_domain::BoundaryFace& face : domain.boundary.faces()) {
    const Vector t = traction_on(face);
    const Vector z = dashpot_diagonal(face);
    face_weights(domain, face, weights);
    for (const auto& [n, w] : weights) {
      grid.force_x[n] += w * face.length * t.x;
      grid.force_y[n] += w * face.length * t.y;
      grid.dashpot_x[n] += w * face.length * z.x;
      grid.dashpot_y[n] += w * face.length * z.y;
    }
  }
}

} // namespace tremolo::test_support
