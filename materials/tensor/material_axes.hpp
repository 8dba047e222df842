#pragma once

// Axes that turn with the material. A law with tensor-valued memory (back stress, fabric, centres of yield
// surfaces), or with rules tied to the plane that was horizontal at the start, works in these axes: its
// memory is kept in them and need not be rotated at all,
//
//     theta <- theta + 2 atan(w/2),    sigma' = R^T sigma R,    d_eps' = R^T d_eps R,    R = R(theta),
//
// theta the angle by which the rotation increments w have turned the material so far (objective_rate.hpp: the
// same Q, so that an elastic law gives the same stress either way). A rigid rotation changes nothing in the
// axes of the material.

#include "materials/tensor/objective_rate.hpp"

#include <cmath>

namespace tremolo::materials {

/// The in-plane axes of one point's material.
class MaterialAxes {
public:
  /// @param angle  theta, rad, counter-clockwise positive
  explicit MaterialAxes(double angle) {
    if (angle != 0.0) {
      cosine2_ = std::cos(2.0 * angle);
      sine2_ = std::sin(2.0 * angle);
    }
  }

  /// theta after a rotation increment w (rad)
  static double turned(double angle, double w) { return w == 0.0 ? angle : angle + 2.0 * std::atan(0.5 * w); }

  /// Components of a stress in the axes of the material, from those in the axes of space.
  InPlaneStress to_material(const InPlaneStress& s) const { return turn(s, -sine2_); }
  /// And back.
  InPlaneStress to_space(const InPlaneStress& s) const { return turn(s, sine2_); }

private:
  InPlaneStress turn(const InPlaneStress& s, double sine2) const {
    const double mean = 0.5 * (s.xx + s.yy);
    const double half = 0.5 * (s.xx - s.yy);
    const double turned_half = half * cosine2_ - s.xy * sine2;
    return {mean + turned_half, mean - turned_half, half * sine2 + s.xy * cosine2_};
  }

  double cosine2_ = 1.0;
  double sine2_ = 0.0;
};

} // namespace tremolo::materials
