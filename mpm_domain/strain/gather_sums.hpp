#pragma once

#include "mpm_domain/ranks/exact_sum.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

/// Sums over some particles of a gather, and their largest speed.
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

/// Sums over all particles of one rank, and their largest speed.
struct GatherTotals {
  ExactSums<3> works; ///< elastic, plastic, viscous, J/m
  double max_speed = 0.0;

  void add(const GatherSums& more) {
    works[0].add(more.elastic);
    works[1].add(more.plastic);
    works[2].add(more.viscous);
    max_speed = std::max(max_speed, more.max_speed);
  }
  GatherTotals& operator+=(const GatherTotals& more) {
    for (std::size_t i = 0; i < works.size(); ++i)
      works[i] += more.works[i];
    max_speed = std::max(max_speed, more.max_speed);
    return *this;
  }
};

} // namespace tremolo::mpm_domain
