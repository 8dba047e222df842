#pragma once

#include "freefield/twophase/wet_grid.hpp"

#include <vector>

namespace tremolo::freefield {

/// The largest stable step of the column's central differences, s: h/c_1 of the element in which it is least,
/// c_1 the speed of the fast wave without drag, and less with stiffness-proportional damping. Permeability
/// sets no limit.
/// @param p_moduli  M of the skeleton in each element, Pa
double step_limit(const WetGrid& grid, const std::vector<double>& p_moduli);

} // namespace tremolo::freefield
