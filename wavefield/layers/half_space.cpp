#include "wavefield/layers/half_space.hpp"

#include "base/require.hpp"

#include <cmath>
#include <numbers>

namespace tremolo::wavefield {

double slowness_x(const HalfSpace& half_space, const Incidence& incidence) {
  const double speed = incidence.wave == WaveType::SV ? half_space.vs : half_space.vp;
  return std::sin(incidence.angle_rad) / speed;
}

bool is_post_critical(const HalfSpace& half_space, const Incidence& incidence) {
  return incidence.wave == WaveType::SV && slowness_x(half_space, incidence) * half_space.vp > 1.0;
}

void validate(const HalfSpace& half_space) {
  require_positive("half-space density", half_space.density, "kg/m3");
  require_positive("half-space vs", half_space.vs, "m/s");
  require_positive("half-space vp", half_space.vp, "m/s");
  const double lowest = std::sqrt(4.0 / 3.0) * half_space.vs;
  require(half_space.vp > lowest, "half-space vp", half_space.vp,
          "above sqrt(4/3) vs, here " + shortest(lowest) + " m/s, for a positive bulk modulus");
}

void validate(const Incidence& incidence) {
  require(incidence.angle_rad >= 0.0 && incidence.angle_rad < std::numbers::pi / 2.0, "angle of incidence",
          incidence.angle_rad, "in [0, pi/2) rad from the vertical");
  require(std::isfinite(incidence.x_reference), "x of the reference point", incidence.x_reference, "finite");
  require(std::isfinite(incidence.y_reference), "y of the reference point", incidence.y_reference, "finite");
}

} // namespace tremolo::wavefield
