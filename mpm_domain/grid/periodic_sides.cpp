#include "mpm_domain/grid/periodic_sides.hpp"

#include <cmath>

namespace tremolo::mpm_domain {

void wrap(Particles& particles, const Box& box) {
  const double period = box.x_max - box.x_min;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const double shift = -period * std::floor((particles.x[k] - box.x_min) / period);
    particles.x[k] += shift;
    particles.x_initial[k] += shift;
  }
}

} // namespace tremolo::mpm_domain
