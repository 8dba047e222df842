#pragma once

#include "freefield/twophase/wet_grid.hpp"

#include <vector>

namespace tremolo::freefield {

/// The largest stable step of the column's central differences, s: h sqrt(1/c_1^2 - s^2) of the element in
/// which it is least, c_1 the speed of the fast wave without drag, and less with stiffness-proportional
/// damping; 0 where the wave is critical. Permeability sets no limit.
/// @param p_moduli  M of the skeleton in each element, Pa
/// @param slowness_x  s, horizontal slowness of the wave that comes in, s/m
double step_limit(const WetGrid& grid, const std::vector<double>& p_moduli, double slowness_x = 0.0);

/// c_1 of an element, m/s.
double fast_wave_speed(const WetGrid& grid, std::size_t element, double p_modulus);

} // namespace tremolo::freefield
