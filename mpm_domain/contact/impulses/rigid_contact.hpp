#pragma once

// A rigid body against all nodes that it touches, at once. With U = (V, omega) the body's motion, W =
// diag(M, M, I), and at each node the normal n from soil to body, the tangent t = (-n_y, n_x), the arm x from
// the centre of mass, J_n = (n, x cross n), J_t = (t, x cross t), the impulses on the body are N n + T t,
// those on the soil their opposites, and
//
//     N  = m (v_n - J_n U),                      total normal impulse, m = m_s + m_f, v_n = P.n/m,
//     N' = N - p A dt = a' - m' J_n U,           effective one: what water bears carries no friction,
//     T  = m* (v_t - J_t U)  where the node sticks,      T = s (mu N' + c A dt)  where it slips, s = +-1.
//
// P is the trial momentum of grains and water, which drag between them leaves as it is; water at a wall takes
// the wall's normal velocity, so
//
//     p A dt = m~_f (v_f*.n - J_n U),      m~_f = rho_f V,
//
// with v_f* the fluid's velocity had there been no drag: with drag in it, liquefied soil would rub. Friction
// acts on the grains alone, and drag lambda ties the water to these: m* = m/(1 + (m_f/m_s)/(1 + lambda dt)).
// This is Eq. (7) of the paper for normal velocities, with an undrained interface and the friction of
// effective stress.
//
// A node is tied in the normal direction while it is closed (its gap is not open) and N > 0, or its water
// bears suction: p above the cavitation pressure. The sets of tied and slipping nodes are found by repeated
// solution for U, (W + sum ...) U = r, until no set changes; where that fails, by Gauss-Seidel on accumulated
// impulses.

#include "mpm_domain/contact/rigid_body.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace tremolo::mpm_domain {

/// A node that a body may touch: its trial motion, what binds it, and the impulses found.
struct ContactPoint {
  Vector arm;    ///< of the node from the body's centre of mass, m
  Vector normal; ///< from soil to body
  Vector tangent() const { return {-normal.y, normal.x}; }

  double mass = 0.0;          ///< m of all phases, kg/m
  double tangential = 0.0;    ///< m*, kg/m
  double normal_speed = 0.0;  ///< v_n, m/s
  double slip_speed = 0.0;    ///< v_t of the grains, m/s
  double full_water = 0.0;    ///< m~_f, kg/m; 0: dry
  double water_impulse = 0.0; ///< m~_f v_f*.n, kg/s
  double least_water = 0.0;   ///< p_cav, less what is hydrostatic, times A dt, kg/s; of wet nodes
  double friction = 0.0;      ///< mu
  double adhesion = 0.0;      ///< c A dt, kg/s
  bool closed = true;

  bool tied = true;                ///< in the normal direction
  int slip = 0;                    ///< s; 0: the node sticks
  double normal_impulse = 0.0;     ///< N, kg/s
  double effective_impulse = 0.0;  ///< N', kg/s
  double tangential_impulse = 0.0; ///< T, kg/s

  /// The bound of friction, kg/s; what of it goes with N' counts while N' > 0.
  double bound(double effective) const { return friction * std::max(0.0, effective) + adhesion; }
  bool wet() const { return full_water > 0.0; }
  double pull_normal(const RigidMotion& u) const { return dot(normal, u.at(arm)); }
  double pull_tangential(const RigidMotion& u) const { return dot(tangent(), u.at(arm)); }
};

/// Response of a body to impulses while its nodes stay in their sets: dU = R J^T j, stored by rows.
using Response = std::array<double, 9>;

struct ContactSolution {
  RigidMotion motion; ///< U
  Response response;
  int passes = 0; ///< solutions for U that it took; 0: Gauss-Seidel
};

/// @param mass, inertia  M (kg/m) and I (kg m) of the body
/// @param trial          its motion without contact
/// @param bonded         all closed nodes stick, whatever they would bear
/// The sets of the points are where the search begins.
ContactSolution solve_contact(double mass, double inertia, const RigidMotion& trial,
                              std::span<ContactPoint> points, bool bonded = false);

} // namespace tremolo::mpm_domain
