#pragma once

// A ring in elastic ground without end that is sheared by gamma, the exact solution of both: with phi =
// theta - 45 degrees and s = G gamma,
//
//     2G u_r = (s r + 2A/r^3 + 4(1 - nu)B/r) cos 2 phi,    2G u_t = (-s r + 2A/r^3 - 2(1 - 2nu)B/r) sin 2
//     phi, s_rr = (s - 6A/r^4 - 4B/r^2) cos 2 phi,              s_rt = (-s - 6A/r^4 - 2B/r^2) sin 2 phi
//
// in the ground, and u_r = U cos 2 phi, u_t = W sin 2 phi on the axis of the ring,
//
//     N = EA (2W + U)/R,      M = 2EI (W + 2U)/R^2,
//
// where the ground touches it at R_o = R + t/2, so that shear there turns its sections:
//
//     N + 4M/R = R_o (s_rr + s_rt t/R),      2N + 2M/R = R_o s_rt (1 + t/(2R)).

#include "tests/support/beam_ring.hpp"

#include "base/vector.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace tremolo::test_support {

/// A, B, U and W for the ring of beam_ring.hpp, and what follows from them.
struct RingInShear {
  Eigen::Vector4d of;
  double shear;          ///< G, Pa
  double poisson;        ///< nu
  double stress;         ///< s, Pa
  double thrust, moment; ///< amplitudes of N (N/m) and M (N)

  /// @param shear_   of the ground, Pa
  /// @param poisson_ likewise
  /// @param strain   gamma
  /// @param sticks   no slip; else full slip
  RingInShear(double shear_, double poisson_, double strain, bool sticks)
      : shear(shear_), poisson(poisson_), stress(shear * strain) {
    const double r = ring_radius;
    const double t = ring_thickness;
    const double ro = r + 0.5 * t;
    const double ea = ring_section.axial;
    const double ei = ring_section.bending;
    const Eigen::Vector4d n(0.0, 0.0, ea / r, 2.0 * ea / r);
    const Eigen::Vector4d m(0.0, 0.0, 4.0 * ei / (r * r), 2.0 * ei / (r * r));
    const Eigen::Vector4d rr(-6.0 / std::pow(ro, 4), -4.0 / (ro * ro), 0.0, 0.0); // less s
    const Eigen::Vector4d rt(-6.0 / std::pow(ro, 4), -2.0 / (ro * ro), 0.0, 0.0); // less -s
    const double per_g = 0.5 / shear;
    const Eigen::Vector4d ur(per_g * 2.0 / std::pow(ro, 3), per_g * 4.0 * (1.0 - poisson) / ro, 0.0, 0.0);
    const Eigen::Vector4d ut(per_g * 2.0 / std::pow(ro, 3), -per_g * 2.0 * (1.0 - 2.0 * poisson) / ro, 0.0,
                             0.0);
    Eigen::Matrix4d a;
    Eigen::Vector4d b;
    a.row(0) = n + 4.0 / r * m - ro * (rr + t / r * rt);
    b(0) = ro * stress * (1.0 - t / r);
    a.row(1) = 2.0 * n + 2.0 / r * m - ro * (1.0 + 0.5 * t / r) * rt;
    b(1) = -ro * stress * (1.0 + 0.5 * t / r);
    a.row(2) = ur - Eigen::Vector4d(0.0, 0.0, 1.0, 0.0);
    b(2) = -per_g * stress * ro;
    const Eigen::Vector4d surface(0.0, 0.0, t / r, 1.0 + 0.5 * t / r); // u_t of the ring at R_o
    a.row(3) = sticks ? Eigen::Vector4d(ut - surface) : rt;
    b(3) = sticks ? per_g * stress * ro : stress;
    // The unknowns differ by many powers of ten.
    const Eigen::Vector4d scale(stress * std::pow(ro, 4), stress * ro * ro, strain * ro, strain * ro);
    const Eigen::Vector4d rows = (a * scale.asDiagonal()).cwiseAbs().rowwise().maxCoeff().cwiseInverse();
    of = scale.asDiagonal() *
         (rows.asDiagonal() * a * scale.asDiagonal()).fullPivLu().solve(rows.asDiagonal() * b);
    thrust = n.dot(of);
    moment = m.dot(of);
  }
  /// Displacement of the ground, m.
  Vector at(const Vector& position) const {
    const double r = std::hypot(position.x, position.y);
    const double theta = std::atan2(position.y, position.x);
    const double twice = 2.0 * theta - 0.5 * std::numbers::pi;
    const double ur = 0.5 / shear *
                      (stress * r + 2.0 * of(0) / std::pow(r, 3) + 4.0 * (1.0 - poisson) * of(1) / r) *
                      std::cos(twice);
    const double ut = 0.5 / shear *
                      (-stress * r + 2.0 * of(0) / std::pow(r, 3) - 2.0 * (1.0 - 2.0 * poisson) * of(1) / r) *
                      std::sin(twice);
    return {ur * std::cos(theta) - ut * std::sin(theta), ur * std::sin(theta) + ut * std::cos(theta)};
  }
};

} // namespace tremolo::test_support
