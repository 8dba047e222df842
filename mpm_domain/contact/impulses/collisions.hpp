#pragma once

// Bodies against each other. A corner of one that comes near the other's surface must not cross it within the
// step: with g >= 0 its gap and n the normal from body a to body b,
//
//     (v_a - v_b).n <= g/dt,      N >= 0,      |T| <= mu N,
//
// without restitution. Impulses are accumulated and swept over the corners until they stay; a body answers
// with the soil that is tied to it (Response of rigid_contact.hpp).

#include "mpm_domain/contact/impulses/rigid_contact.hpp"

#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// A corner of a body next to another body.
struct CornerContact {
  std::size_t a = 0; ///< indices of the two bodies
  std::size_t b = 0;
  Vector arm_a, arm_b; ///< of the point from the centres of mass, m
  Vector normal;       ///< from a to b
  double gap = 0.0;    ///< m; negative: they overlap
  double friction = 0.0;
  double normal_impulse = 0.0;     ///< on b along n; on a the opposite, kg/s
  double tangential_impulse = 0.0; ///< on b along (-n_y, n_x)

  Vector impulse() const {
    return {normal_impulse * normal.x - tangential_impulse * normal.y,
            normal_impulse * normal.y + tangential_impulse * normal.x};
  }
};

/// The corners of all pairs of rigid bodies that are closer to the other body than a distance (m).
/// @param structures  of the bodies; of the frictions of two the smaller counts
std::vector<CornerContact> find_corners(std::span<const RigidBody> bodies,
                                        std::span<const Structure> structures, double distance);

/// Finds impulses for bodies that move by `motions`, whose parts from earlier impulses are included, and
/// changes both.
/// @returns the largest change of an impulse, kg/s
double resolve(std::span<CornerContact> corners, std::span<RigidMotion> motions,
               std::span<const Response> responses, double dt);

} // namespace tremolo::mpm_domain
