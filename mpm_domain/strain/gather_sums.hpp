#pragma once

#include <algorithm>

namespace tremolo::mpm_domain {

/// Sums over the particles of a gather, and their largest speed.
struct GatherSums {
  double elastic = 0.0;   ///< work of the stresses on elastic strain, J/m
  double plastic = 0.0;   ///< work of the stresses on plastic strain, J/m
  double viscous = 0.0;   ///< work of the viscous stresses, J/m
  double max_speed = 0.0; ///< of particles that were moved, m/s

  GatherSums& operator+=(const GatherSums& more) {
    elastic += more.elastic;
    plastic += more.plastic;
    viscous += more.viscous;
    max_speed = std::max(max_speed, more.max_speed);
    return *this;
  }
};

} // namespace tremolo::mpm_domain
