#pragma once

#include "scene/case.hpp"

#include <optional>

namespace tremolo::scene {

/// Vertical effective stress of the level ground at y, Pa, positive in compression: that of the layers of
/// [[profile]] below the free surface, and of the half-space below them, with hydrostatic pore pressure below
/// the water table. Gravity is that of the case, 9.81 m/s2 where it has none. Nothing above the surface.
std::optional<double> level_ground_stress(const Case& scene, double y);

} // namespace tremolo::scene
