#pragma once

// The soil that goes on moving in a model that finds no rest: its slip surface is where what moves meets what
// does not.

#include "mpm_domain/domain.hpp"

#include <optional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// A particle of soil of a model that fails.
struct MovingPoint {
  Vector position;             ///< m
  double size = 0.0;           ///< a side of it, m
  Vector velocity;             ///< over that of the fastest particle, 1; 0 if none moves
  double plastic_strain = 0.0; ///< equivalent plastic deviatoric strain, 1; 0 for laws without
};

/// All soil of a domain that did not come to rest under gravity.
std::vector<MovingPoint> mechanism_of(Domain& domain);

/// Extent of the soil that moves at least a tenth as fast as the fastest.
struct Extent {
  double x_min = 0.0; ///< m
  double x_max = 0.0;
  double depth = 0.0; ///< largest depth below the surface above it, m
  double rows = 0.0;  ///< likewise, in sizes of the particles there
};

/// Empty if only structures move.
std::optional<Extent> extent_of(std::span<const MovingPoint> mechanism);

} // namespace tremolo::mpm_domain
