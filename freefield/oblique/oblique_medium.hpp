#pragma once

#include "freefield/profile.hpp"
#include "materials/elastic/elasticity.hpp"

#include <Eigen/Core>

namespace tremolo::freefield {

/// Plane waves of one horizontal slowness p (s/m) as a system in depth and time,
///     A da/dt = db/dy,   B db/dt = da/dy,   a = (vx, syy),   b = (sxy, vy).
struct ObliqueMedium {
  Eigen::Matrix2d a; ///< symmetric, positive definite if p < 1/c_p
  Eigen::Matrix2d b;
};

ObliqueMedium oblique_medium(const materials::Elasticity& soil, double slowness_x);

/// Vertical slowness sqrt(1/c^2 - p^2) of a wave of speed c (m/s), s/m.
double vertical_slowness(double speed, double slowness_x);

/// What the half-space answers at its top: b = outgoing a + incident v.
struct ObliqueBase {
  Eigen::Matrix2d outgoing; ///< of waves that go down
  Eigen::Matrix2d incident; ///< v: velocity (vx, vy) of the incident wave, m/s
};

ObliqueBase oblique_base(const materials::Elasticity& half_space, double slowness_x);

/// @throws std::invalid_argument unless 0 <= p < 1/c_p in every layer and in the half-space
void validate_slowness(const Profile& profile, double slowness_x);

} // namespace tremolo::freefield
