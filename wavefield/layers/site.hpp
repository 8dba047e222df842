#pragma once

#include "wavefield/layers/layered_half_space.hpp"

#include <cstddef>

namespace tremolo::wavefield {

/// Mean shear wave speed of the uppermost `depth` metres as codes take it, depth over travel time: Vs30 at
/// 30 m. Below the layers lies the half-space. m/s
/// @throws std::invalid_argument for a depth that is not above 0, or a profile that is not valid
double mean_shear_speed(const LayeredHalfSpace& profile, double depth);

/// Fundamental period of the layers without damping, shaken horizontally on a base that does not yield, s.
/// @throws std::invalid_argument for a profile that is not valid or has no layers
double fundamental_period(const LayeredHalfSpace& profile);

/// rho vs of what lies below layer `index` (from the top) over rho vs of that layer, 1.
double impedance_contrast(const LayeredHalfSpace& profile, std::size_t index);

} // namespace tremolo::wavefield
