#pragma once

// Checks of a served field by its values alone, whoever computed them:
//
//  - rates belong to the values. By Simpson's rule, exact for cubics in time, error (w dt)^4/180,
//        f_(n+1) - f_(n-1) = dt/3 (f'_(n-1) + 4 f'_n + f'_(n+1));
//  - values obey the balance of momentum, whatever the soil. On a vertical line of a field that is the same
//    along x, later by p (x - x_ref), d/dx = -p d/dt, so
//        rho vx' = -p sxx' + dsxy/dy,     rho vy' = -p sxy' + dsyy/dy,
//    which gives the density: a stress in kPa, a velocity in cm/s or a wrong sign shows in it at once.

#include "coupler/wire/field.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace tremolo::coupler {

/// Steps 0, 1, ... of a field as they came.
struct ServedSeries {
  FieldDescription field;
  std::vector<double> values; ///< [steps, points, values_per_point]

  [[nodiscard]] std::uint64_t steps() const { return values.size() / field.values_per_step(); }
};

/// Largest magnitudes.
struct Peaks {
  double velocity = 0.0; ///< m/s
  double stress = 0.0;   ///< Pa
};
/// @param first,last steps, both included
Peaks peaks(const ServedSeries& series, std::uint64_t first, std::uint64_t last);

/// The 2-norm of what Simpson's rule leaves over that of its sides, the larger of velocity and stress; 0 of a
/// field that is zero.
double rate_defect(const ServedSeries& series);

/// The density (kg/m3) that fits the balance of momentum best; nothing if no three points stand within a
/// layer or nothing moves.
std::optional<double> density_from_momentum(const ServedSeries& series);

enum class Direction { horizontal, vertical };

/// The balance of momentum in one direction.
struct MomentumFit {
  double density = 0.0; ///< kg/m3
  double misfit = 0.0;  ///< 2-norm of what this density leaves over that of the divergence of the stress
};
/// Empty if density_from_momentum() is empty, or if nothing moves in this direction.
std::optional<MomentumFit> momentum_fit(const ServedSeries& series, Direction direction);

} // namespace tremolo::coupler
