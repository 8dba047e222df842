#pragma once

#include "materials/water/pore_water.hpp"

namespace tremolo::scene {

/// [water]: the water table and the water below it. A table above the ground is free water that the ground
/// carries.
struct GroundWater {
  double level = 0.0; ///< y of the table, m
  materials::PoreFluid fluid;

  /// Hydrostatic pressure at y, Pa; 0 above the table.
  double pressure(double y, double gravity) const {
    return y < level ? fluid.density * gravity * (level - y) : 0.0;
  }
};

} // namespace tremolo::scene
