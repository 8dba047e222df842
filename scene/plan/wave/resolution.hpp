#pragma once

#include "scene/case.hpp"

namespace tremolo::scene {

/// Number of cells per wavelength that shear waves need to be resolved.
inline constexpr double cells_per_wavelength = 15.0;

/// The highest frequency of shear waves that cells of a size resolve in the slowest soil of the domain, Hz.
/// @param cell_size m
double resolved_frequency(const Case& scene, double cell_size);

} // namespace tremolo::scene
