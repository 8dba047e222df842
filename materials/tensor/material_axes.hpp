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

#include "base/lanes.hpp"
#include "materials/tensor/objective_rate.hpp"
#include "materials/tensor/sine_cosine.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace tremolo::materials {

/// 2 atan(w/2), rad, by its Taylor series to w^13: to rounding for |w| up to 0.05.
template <typename Real>
Real small_turn(const Real& w) {
  const Real t = 0.25 * w * w;
  Real sum = constant<Real>(1.0 / 13.0);
  for (const double odd : {11.0, 9.0, 7.0, 5.0, 3.0})
    sum = 1.0 / odd - t * sum;
  return w - w * t * sum;
}

/// 2 atan(w/2) for any w, rad.
inline double turn_of(double w) {
  return std::abs(w) <= 0.05 ? small_turn(w) : 2.0 * std::atan(0.5 * w);
}
inline Lanes turn_of(const Lanes& w) {
  Lanes turn = small_turn(w);
  if (any(~(magnitude(w) <= 0.05)))
    for (std::size_t lane = 0; lane < 4; ++lane)
      if (!(std::abs(w[lane]) <= 0.05))
        turn[lane] = turn_of(w[lane]);
  return turn;
}

/// The in-plane axes of the material of one point, or of four where Real is Lanes.
template <typename Real>
class MaterialAxesOf {
public:
  /// @param angle  theta, rad, counter-clockwise positive
  explicit MaterialAxesOf(const Real& angle) {
    constexpr double round = 6755399441055744.0;      // 1.5 2^52: adding it leaves a whole number
    constexpr double pi_low = 1.2246467991473532e-16; // pi less its double
    const auto of = [](double value) { return constant<Real>(value); };
    // 2 theta = k pi + rest: sine and cosine are those of the rest, with the other sign where k is odd.
    const Real k = fma(angle, of(2.0 / std::numbers::pi), of(round)) - round;
    const Real rest = fma(-k, of(pi_low), fma(-k, of(std::numbers::pi), 2.0 * angle));
    const Real sign = 1.0 - 2.0 * (k - 2.0 * floor(0.5 * k));
    const SineCosineOf<Real> of_rest = sine_cosine(rest);
    cosine2_ = sign * of_rest.cosine;
    sine2_ = sign * of_rest.sine;
  }

  /// theta after a rotation increment w (rad)
  static Real turned(const Real& angle, const Real& w) { return angle + turn_of(w); }

  /// Components of a stress in the axes of the material, from those in the axes of space.
  InPlaneStressOf<Real> to_material(const InPlaneStressOf<Real>& s) const { return turn(s, -sine2_); }
  /// And back.
  InPlaneStressOf<Real> to_space(const InPlaneStressOf<Real>& s) const { return turn(s, sine2_); }

private:
  InPlaneStressOf<Real> turn(const InPlaneStressOf<Real>& s, const Real& sine2) const {
    const Real mean = 0.5 * (s.xx + s.yy);
    const Real half = 0.5 * (s.xx - s.yy);
    const Real turned_half = half * cosine2_ - s.xy * sine2;
    return {mean + turned_half, mean - turned_half, half * sine2 + s.xy * cosine2_};
  }

  Real cosine2_;
  Real sine2_;
};
using MaterialAxes = MaterialAxesOf<double>;

} // namespace tremolo::materials
