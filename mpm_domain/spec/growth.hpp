#pragma once

#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {

/// A ramp from 0 to 1 along half a cosine as s goes from 0 to 1, without a jump of velocity.
inline double ramped(double s) {
  if (s <= 0.0)
    return 0.0;
  return s < 1.0 ? 0.5 * (1.0 - std::cos(std::numbers::pi * s)) : 1.0;
}

/// Growth of a change while the ground moves: share(t) = (1 - cos(pi (t - t_0)/T))/2.
struct Growth {
  double start = 0.0;    ///< t_0, simulated time, s
  double duration = 0.0; ///< T, s, > 0

  double share(double time) const { return ramped((time - start) / duration); }
};

} // namespace tremolo::mpm_domain
