// Somebody else's program: the motion of the ground above a vertically incident SV wave, which a free surface
// doubles.

#include "materials/law/law.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

int main() {
  namespace wave = tremolo::wavefield;
  const tremolo::materials::Elasticity soil{1700.0, 40e6, 0.28};
  const wave::HalfSpace half_space{soil.density, soil.s_wave_speed(), soil.p_wave_speed()};
  const double peak = 0.1; // m/s
  const wave::LayeredField field({.half_space = half_space}, wave::Incidence{}, 0.0,
                                 wave::ricker(3.0, 1.0, peak));
  const wave::Point surface{0.0, 0.0};
  const wave::History history = field.sample({&surface, 1}, {0.0, 0.001, 3000}).front();
  const double largest = *std::max_element(history.vx.begin(), history.vx.end());
  std::printf("peak %.6f m/s\n", largest);
  return std::abs(largest - 2.0 * peak) < 1e-4 * peak ? 0 : 1;
}
