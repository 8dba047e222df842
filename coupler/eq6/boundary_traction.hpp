#pragma once

// Eq. (6) of Gao, Wang et al. (MPM for geotechnical earthquake engineering): the traction on a boundary face,
//
//     f_i^b = f_i^{b,vis} + f_i^{b,dyn} + f_i^{b,st},
//
//     f^vis = -rho c_p [(v^m - v^ff).n] n - rho c_s [(v^m - v^ff).t] t     Lysmer dashpots on the difference
//     f^dyn = sigma^ff,dyn n                                               free-field dynamic stress
//     f^st                                                                 what held the model at rest
//
// with n the outward unit normal and t = (-n_y, n_x). Eqs. (2) to (5) are special cases: a side takes v^ff
// and sigma^ff from its free field; a transmitting base takes them from the incident wave alone, which at
// vertical incidence is -rho c (v^m - 2 v^inp).
//
// Every product that is added goes through std::fma: the result is then the same bits wherever the function
// is inlined, so the coupler (lockstep) and the domain (window) cannot differ.

#include "base/vector.hpp"

#include <cmath>

namespace tremolo::eq6 {

using tremolo::Vector;

/// Dynamic stress in the plane, Pa, tension positive.
struct Stress {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
};

/// Properties of a boundary face that its dashpot needs.
struct Face {
  Vector normal;            ///< outward unit normal
  double impedance_p = 0.0; ///< rho c_p, Pa s/m
  double impedance_s = 0.0; ///< rho c_s, Pa s/m
};

/// Free-field motion at a face: particle velocity (m/s) and dynamic stress (Pa).
struct FreeField {
  Vector velocity;
  Stress stress;
};

/// The viscous part of Eq. (6) alone for a velocity difference dv = v^m - v^ff (m/s), in Pa.
inline Vector viscous_traction(const Face& face, Vector dv) {
  const Vector n = face.normal;
  const double dv_n = std::fma(dv.x, n.x, dv.y * n.y);
  const double dv_t = std::fma(dv.y, n.x, -(dv.x * n.y));
  const double p = -face.impedance_p * dv_n;
  const double s = -face.impedance_s * dv_t;
  return {std::fma(p, n.x, -(s * n.y)), std::fma(p, n.y, s * n.x)};
}

/// The dynamic part of Eq. (6) alone: the free field's stress on a plane of outward unit normal n, Pa.
inline Vector dynamic_traction(const Vector& n, const Stress& s) {
  return {std::fma(s.xx, n.x, s.xy * n.y), std::fma(s.xy, n.x, s.yy * n.y)};
}

/// The three parts of Eq. (6), Pa.
struct Traction {
  Vector viscous;
  Vector dynamic;
  Vector held; ///< static

  Vector total() const { return {viscous.x + (dynamic.x + held.x), viscous.y + (dynamic.y + held.y)}; }
};

/// Eq. (6): traction on a face from the domain's velocity there (m/s), the free field, and the static part
/// (Pa).
inline Traction boundary_traction(const Face& face, Vector v_domain, const FreeField& ff, Vector held) {
  return {viscous_traction(face, {v_domain.x - ff.velocity.x, v_domain.y - ff.velocity.y}),
          dynamic_traction(face.normal, ff.stress), held};
}

} // namespace tremolo::eq6
