#pragma once

// Mass-proportional damping of a column is relative to the motion that the rock below it would have without
// soil on top (Chopra 2012, Dynamics of Structures, sec. 11.4: c acts on velocities relative to the ground).
// That is the base's own motion where it is rigid. Over a half-space it is the outcrop motion
//
//     v_ref(t) = 2 v_inc(t - t_rise),    at an angle Z^-1 B v_inc(t - t_rise) (marched/base_impedance.hpp),
//
// t_rise the time of the incident wave from the base through undamped layers to the lowest damped one: a
// column that goes on into the rock has the same damping. So no motion of the ground as a whole is braked.
// The velocity of the base itself is no such reference: the column's damping then feeds on its base's
// motion, and layers of different damping ratios grow without bound.

#include "freefield/column.hpp"

namespace tremolo::freefield {

struct Profile;

/// One component of the motion that enters a column at its base, at one time. Under a compliant base it is
/// the incident wave's and only the velocity is meant.
struct BaseComponent {
  double displacement = 0.0; ///< m
  double velocity = 0.0;     ///< m/s
  double acceleration = 0.0; ///< m/s2
  double reference = 0.0;    ///< v_ref, m/s
};

struct BaseMotion {
  BaseComponent x;
  BaseComponent y;
};

/// t_rise of shear (x) and P waves (y), s.
struct Rise {
  double x = 0.0;
  double y = 0.0;
};

/// @param slowness_x  s, horizontal slowness of the waves, s/m
Rise rise_to_damped_soil(const Profile& profile, double slowness_x = 0.0);

/// v_ref at a time, m/s.
Velocity reference_velocity(BaseKind kind, const InputVelocity& input, const Rise& rise, double time);

/// The input motion at time + step, given what it was at `time`. The displacement of a rigid base follows by
/// Simpson's rule, its acceleration by three-point differences; exact for a velocity that is quadratic in the
/// step.
BaseMotion advanced(BaseKind kind, const InputVelocity& input, const Rise& rise, const BaseMotion& before,
                    double time, double step);

} // namespace tremolo::freefield
