// At an angle each wave moves an outcrop in both directions. With the slowness p, eta_a = sqrt(1/a^2 - p^2)
// and eta_b = sqrt(1/b^2 - p^2), a and b the speeds of P and S waves, the surface of a half-space moves (Aki
// & Richards 2002, sec. 5.2.3)
//
//     under an SV wave     u_y / u_x = -2 p eta_a / (1/b^2 - 2 p^2),
//     under a P wave       u_x / u_y =  2 p eta_b / (1/b^2 - 2 p^2).
//
// So where an SV wave is what the horizontal record of an outcrop asks for, and a P wave what the vertical
// one does, both together move the outcrop otherwise than recorded.

#include "scene/plan/wave/slowness.hpp"
#include "scene/rules/rules.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::scene {

namespace {

constexpr double negligible = 0.01;

/// Motion of the outcrop across the wave's own component over that along it, 1; 0 beyond the critical angle,
/// where an outcrop is refused.
double across(const Case& scene, const MotionInput& wave) {
  const double p = slowness_x(scene, wave);
  const double deep = 1.0 / std::pow(scene.halfspace.p_wave_speed(), 2);
  const double shear = 1.0 / std::pow(scene.halfspace.s_wave_speed(), 2);
  const double of_other = (wave.wave == Wave::sv ? deep : shear) - p * p;
  return of_other > 0.0 ? 2.0 * p * std::sqrt(of_other) / (shear - 2.0 * p * p) : 0.0;
}

} // namespace

void outcrop_moves_as_recorded(const Case& scene, Findings& findings) {
  if (!scene.vertical || scene.motion.kind != motion::MotionKind::outcrop || !scene.boundary.takes_waves() ||
      !findings.sound("motion") || !findings.sound("halfspace"))
    return;
  const double vertically = std::abs(across(scene, scene.motion));
  const double horizontally = std::abs(across(scene, *scene.vertical));
  if (std::max(vertically, horizontally) < negligible)
    return;
  findings.add(
      scene.vertical->path,
      fmt::format(
          "each wave moves the outcrop as its own record says, and at an angle in the other direction "
          "too: the vertical motion of the outcrop is its record and {:.2g} times the horizontal one, "
          "the horizontal motion its record and {:.2g} times the vertical one; both records are met "
          "at angle_deg = 0",
          vertically, horizontally));
}

} // namespace tremolo::scene
