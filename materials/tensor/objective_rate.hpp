#pragma once

// The objective rate that every law here uses: before the strain increment is applied, the stress is rotated
// with the material by the orthogonal tensor of Hughes & Winget (1980), Int. J. Numer. Meth. Eng. 15,
// 1862-1867,
//
//     sigma <- Q sigma Q^T,    Q = (I - W/2)^-1 (I + W/2),    W = [[0, -w], [w, 0]].
//
// Q is a rotation by the angle 2 atan(w/2), exactly orthogonal for any w. It is exact for rigid rotations
// whose w is taken in the mid-step configuration and a second-order integration of the Jaumann rate
// otherwise: an error of w^3/12 rad a step. No trigonometric functions, so a loop over points vectorises.
// What remains of the Jaumann rate is known: shear stress in simple shear of a hypoelastic solid oscillates
// beyond a shear strain of about 0.7. Real is double, or Lanes for four points.

namespace tremolo::materials {

/// The in-plane components of the Cauchy stress, Pa.
template <typename Real>
struct InPlaneStressOf {
  Real xx{};
  Real yy{};
  Real xy{};
};
using InPlaneStress = InPlaneStressOf<double>;

/// Q sigma Q^T for the rotation increment w (rad, counter-clockwise positive).
template <typename Real>
InPlaneStressOf<Real> rotated(const InPlaneStressOf<Real>& stress, const Real& w) {
  const Real a = 0.5 * w;
  const Real scale = 1.0 / (1.0 + a * a);
  const Real cosine = (1.0 - a * a) * scale;
  const Real sine = 2.0 * a * scale;
  const Real cosine2 = cosine * cosine - sine * sine;
  const Real sine2 = 2.0 * sine * cosine;
  const Real mean = 0.5 * (stress.xx + stress.yy);
  const Real half = 0.5 * (stress.xx - stress.yy);
  const Real half_rotated = half * cosine2 - stress.xy * sine2;
  return {mean + half_rotated, mean - half_rotated, half * sine2 + stress.xy * cosine2};
}
inline InPlaneStress rotated(const InPlaneStress& stress, double w) {
  return rotated<double>(stress, w);
}

} // namespace tremolo::materials
