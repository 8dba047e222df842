#include "scene/soils/viscous_damping.hpp"

#include <numbers>

namespace tremolo::scene {

double damping_time(const Damping& damping, double ratio) {
  if (damping.model == DampingModel::none || ratio == 0.0)
    return 0.0;
  const double sum = damping.model == DampingModel::rayleigh ? damping.frequencies[0] + damping.frequencies[1]
                                                             : damping.reference_hz.value_or(0.0);
  return sum > 0.0 ? ratio / (std::numbers::pi * sum) : 0.0;
}

} // namespace tremolo::scene
