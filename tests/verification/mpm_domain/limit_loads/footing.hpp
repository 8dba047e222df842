#pragma once

// A strip footing on clay, whose load is the weight of a block as wide: stiff and bonded to the clay, a rough
// rigid footing, or soft as a liquid in shear, a uniform pressure.

#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

namespace tremolo::mpm_domain::test {

inline constexpr double footing_width = 4.0; // m
inline constexpr double clay_depth = 4.0;    // m

/// The weight of clay without friction is no help to a footing on it.
inline materials::MohrCoulomb light_clay(double poisson, double cohesion) {
  return perfectly_plastic({500.0, 20e6, poisson}, cohesion, 0.0);
}

/// Clay to both sides and below, soil 0 of region 0, and the block, soil 1 of region 1.
/// @param pressure   of the block's weight, Pa
/// @param stiffness  Young's modulus of the block, Pa
inline Spec footing_on_clay(double cell_size, double pressure, double stiffness) {
  constexpr double side = 6.0, block = 1.0; // m
  constexpr double right = 2.0 * side + footing_width;
  Spec spec;
  spec.box = {0.0, -clay_depth, right, block};
  spec.cell_size = cell_size;
  spec.gravity = gravity;
  spec.soils = {{"clay", light_clay(0.3, 20e3)},
                {"block", materials::LinearElastic{{pressure / (gravity * block), stiffness, 0.0}}}};
  spec.regions = {
      {0, {{0.0, -clay_depth}, {right, -clay_depth}, {right, 0.0}, {0.0, 0.0}}},
      {1, {{side, 0.0}, {side + footing_width, 0.0}, {side + footing_width, block}, {side, block}}}};
  return spec;
}

} // namespace tremolo::mpm_domain::test
