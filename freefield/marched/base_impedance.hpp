#pragma once

#include "materials/elastic/elasticity.hpp"

#include <Eigen/Core>

namespace tremolo::freefield {

/// Traction of a half-space on the plane above it, in waves of one horizontal slowness:
/// (sxy, syy) = outgoing v - incident v_inc, v and v_inc the velocities of the plane and of the incident
/// wave.
struct BaseImpedance {
  Eigen::Matrix2d outgoing = Eigen::Matrix2d::Zero(); ///< Z, Pa s/m
  Eigen::Matrix2d incident = Eigen::Matrix2d::Zero(); ///< B, Pa s/m; diagonal
};

/// @param slowness_x  s = sin(angle)/c of the incident wave, s/m, in [0, 1/c_p)
/// @throws std::invalid_argument for a slowness outside
BaseImpedance base_impedance(const materials::Elasticity& half_space, double slowness_x);

} // namespace tremolo::freefield
