#include "mpm_domain/lining/water/water_load.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/lining/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::mpm_domain {

double rest_pressure(const Ground& ground, const Vector& at) {
  if (!ground.head)
    return 0.0;
  const double unit_weight = ground.spec.water->fluid.density * ground.spec.gravity;
  return std::max(0.0, unit_weight * (ground.head->at(at.x, at.y).head - at.y));
}

void add_rest_pressure(const Ground& ground, std::span<const Vector> outline, const Beam& beam,
                       std::span<double> forces) {
  if (!ground.head)
    return;
  const double off = 0.5 / std::sqrt(3.0);
  std::vector<BeamShare> shares;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vector& a = outline[k];
    const Vector& b = outline[(k + 1) % outline.size()];
    const Vector along = b - a;
    for (const double share : std::array{0.5 - off, 0.5 + off}) {
      const Vector at = a + share * along;
      const double half = 0.5 * rest_pressure(ground, at);
      const Vector push{-half * along.y, half * along.x}; // the outline runs counter-clockwise
      shares.clear();
      add_velocity({k, share, {}}, at, 1.0, beam, shares);
      for (const auto& [dof, velocity] : shares)
        forces[dof] += dot(velocity, push);
    }
  }
}

} // namespace tremolo::mpm_domain
