#pragma once

#include "freefield/column.hpp"

namespace tremolo::freefield {

/// One component of the motion that enters a column at its base, at one time. Under a compliant base it is
/// the incident wave's and only the velocity is meant.
struct BaseComponent {
  double displacement = 0.0; ///< m
  double velocity = 0.0;     ///< m/s
  double acceleration = 0.0; ///< m/s2
};

struct BaseMotion {
  BaseComponent x;
  BaseComponent y;
};

/// The input motion at time + step, given what it was at `time`. The displacement of a rigid base follows by
/// Simpson's rule, its acceleration by three-point differences; exact for a velocity that is quadratic in the
/// step.
BaseMotion advanced(BaseKind kind, const InputVelocity& input, const BaseMotion& before, double time,
                    double step);

} // namespace tremolo::freefield
