#pragma once

// PM4Sand at a reversal of loading, which occurs when the back stress ratio begins to move back towards the
// true initial one, (alpha - alpha_in_true):n < 0 (Boulanger & Ziotopoulou 2017, sections 2.6 and 2.9). The
// apparent initial ratio differs from the true one at a small reversal on the same side as the one before
// (the xy components show it): loading then goes on as if it had not been interrupted.

#include "materials/sand/pm4sand/pm4sand_state.hpp"

#include <algorithm>

namespace tremolo::materials::pm4 {

/// One component of the running extremes of alpha at reversals.
inline void extend(double alpha_in, double alpha, double& smallest, double& largest) {
  if (alpha_in > 0.0)
    smallest = std::min(smallest, alpha);
  else
    largest = std::max(largest, alpha);
}

/// The apparent initial component after a small reversal.
inline double apparent(double n, double smallest, double largest) {
  return n > 0.0 ? std::max(0.0, smallest) : std::min(0.0, largest);
}

/// @param n  direction of loading, of any length
/// @param p  Pa, at least p_min
inline void remember_reversal(Memory& memory, const Motion& now, Deviator n, double p) {
  memory.alpha_in_p = memory.alpha_in.deviator();
  memory.alpha_in_true = now.alpha;
  memory.z_in = now.z;

  const double zp = norm(now.z) * p;
  if (memory.zp_max < 0.0 || (zp > memory.zp_max && p > memory.p_zp)) {
    memory.zp_max = zp;
    memory.p_zp = p;
  }

  const Components alpha = Components::of(now.alpha);
  Components& in = memory.alpha_in;
  extend(in.xx, alpha.xx, memory.alpha_min.xx, memory.alpha_max.xx);
  extend(in.yy, alpha.yy, memory.alpha_min.yy, memory.alpha_max.yy);
  extend(in.xy, alpha.xy, memory.alpha_min.xy, memory.alpha_max.xy);
  if (alpha.xy * memory.alpha_in_p.s > 0.0) {
    in = {apparent(n.d, memory.alpha_min.xx, memory.alpha_max.xx),
          apparent(-n.d, memory.alpha_min.yy, memory.alpha_max.yy),
          apparent(n.s, memory.alpha_min.xy, memory.alpha_max.xy)};
  } else {
    in = alpha;
  }
}

} // namespace tremolo::materials::pm4
