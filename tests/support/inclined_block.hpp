#pragma once

// A block on an incline of stiff ground between two level shelves.

#include "tests/support/structure_scene.hpp"

#include <cmath>

namespace tremolo::test_support {

/// @param angle  of the incline, rad
inline mpm_domain::Spec inclined_block(double angle, double friction) {
  constexpr double h = 0.5;
  const double slope = std::tan(angle);
  const double top = std::ceil(4.0 * slope / h) * h;
  mpm_domain::Spec spec = flat_ground(16.0, 10.0, h, {2000.0, 2e9, 0.2});
  spec.box.y_max = 8.0;
  spec.regions.front().polygon = {{-8.0, -10.0},      {8.0, -10.0},         {8.0, top},
                                  {top / slope, top}, {-top / slope, -top}, {-8.0, -top}};
  spec.structures = {structure(turned(rectangle(-1.0, 0.0, 1.0, 1.0), {0.0, 0.0}, angle), 2000.0, friction)};
  return spec;
}

/// Its acceleration where it slides, m/s2.
inline double exact_acceleration(double angle, double friction) {
  return 9.81 * (std::sin(angle) - friction * std::cos(angle));
}

/// Its acceleration down the incline over 0.3 s, once the soil has sprung back from the bonds, m/s2.
inline double measured_acceleration(StandingScene& scene, double angle) {
  const auto speed = [&] {
    const Vector v = scene.body().motion().velocity;
    return -(v.x * std::cos(angle) + v.y * std::sin(angle));
  };
  scene.run(0.1);
  const double t = scene.stepper.velocity_time();
  const double v = speed();
  scene.run(0.3);
  return (speed() - v) / (scene.stepper.velocity_time() - t);
}

} // namespace tremolo::test_support
