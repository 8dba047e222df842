#include "scene/plan/wave/resolution.hpp"

#include "scene/soils/domain_soils.hpp"

#include <algorithm>
#include <limits>

namespace tremolo::scene {

double resolved_frequency(const Case& scene, double cell_size) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const Soil& soil : domain_soils(scene))
    slowest = std::min(slowest, materials::elasticity(soil.law).s_wave_speed());
  return slowest / (cells_per_wavelength * cell_size);
}

} // namespace tremolo::scene
