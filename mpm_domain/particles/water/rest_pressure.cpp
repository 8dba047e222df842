#include "mpm_domain/particles/water/rest_pressure.hpp"

#include <limits>

namespace tremolo::mpm_domain {

void follow_head(Particles& p, std::size_t begin, std::size_t end, const Head& head) {
  for (std::size_t k = begin; k < end; ++k) {
    const HeadThere there = head.at(p.x[k], p.y[k]);
    p.head[k] = there.head;
    p.head_slope_x[k] = there.slope.x;
    p.head_slope_y[k] = there.slope.y;
  }
}

void take_head(Particles& p, const Head& head) {
  p.traits.seeping = head.level() == nullptr;
  p.water->level = p.traits.seeping ? std::numeric_limits<double>::quiet_NaN() : *head.level();
  for (std::vector<double>* column : {&p.head, &p.head_slope_x, &p.head_slope_y})
    column->resize(p.traits.seeping ? p.size() : 0);
  if (p.traits.seeping)
    follow_head(p, 0, p.size(), head);
  for (std::size_t k = 0; p.traits.wet && k < p.size(); ++k)
    p.pore_pressure[k] = p.pressure_at_rest[k] = rest_pressure(p, k);
}

} // namespace tremolo::mpm_domain
