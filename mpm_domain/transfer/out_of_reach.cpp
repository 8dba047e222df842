#include "mpm_domain/transfer/out_of_reach.hpp"

#include <fmt/format.h>

namespace tremolo::mpm_domain {

void refuse_stray(const Particles& p, std::size_t k, double way) {
  throw OutOfReach(fmt::format(
      "particle {} of {} '{}' at x = {:.6g} m, y = {:.6g} m has gone farther than {:.3g} m since particles "
      "were last sorted, with a velocity of {:.3g}, {:.3g} m/s: its motion is not physical",
      p.id[k], p.body ? "structure" : "soil", p.soil, p.x[k], p.y[k], way, p.vx[k], p.vy[k]));
}

} // namespace tremolo::mpm_domain
