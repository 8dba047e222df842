#pragma once

#include "materials/law/driver.hpp"

#include <cmath>
#include <numbers>

namespace tremolo::materials::test {

inline constexpr double degree = std::numbers::pi / 180.0;
inline constexpr double kPa = 1e3;

/// Table 1 of Gao, Wang et al.: strain-softening soil of the 10 m slope.
inline MohrCoulomb slope_soil() {
  MohrCoulomb soil;
  soil.elastic = {1700.0, 40e6, 0.28};
  soil.cohesion_peak = 4.0 * kPa;
  soil.cohesion_residual = 0.0;
  soil.friction_peak = 45.0 * degree;
  soil.friction_residual = 28.0 * degree;
  soil.softening = 15.0;
  return soil;
}

/// The slope soil with its residual strength from the start.
inline MohrCoulomb residual_soil() {
  MohrCoulomb soil = slope_soil();
  soil.cohesion_peak = soil.cohesion_residual;
  soil.friction_peak = soil.friction_residual;
  soil.softening = 0.0;
  return soil;
}

/// Perfectly plastic soil.
inline MohrCoulomb perfect_soil(double friction_deg, double dilation_deg, double cohesion) {
  MohrCoulomb soil = slope_soil();
  soil.cohesion_peak = soil.cohesion_residual = cohesion;
  soil.friction_peak = soil.friction_residual = friction_deg * degree;
  soil.dilation_peak = soil.dilation_residual = dilation_deg * degree;
  soil.softening = 0.0;
  return soil;
}

/// N = (1 + sin phi) / (1 - sin phi)
inline double flow_value(double friction) {
  return (1.0 + std::sin(friction)) / (1.0 - std::sin(friction));
}

} // namespace tremolo::materials::test
