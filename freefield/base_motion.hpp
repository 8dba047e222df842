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

/// t_rise of shear (x) and P waves (y), s.
struct Rise {
  double x = 0.0;
  double y = 0.0;
};

/// @param slowness_x  s, horizontal slowness of the waves, s/m
Rise rise_to_damped_soil(const Profile& profile, double slowness_x = 0.0);

/// v_ref at a time, m/s.
Velocity reference_velocity(BaseKind kind, const InputVelocity& input, const Rise& rise, double time);

} // namespace tremolo::freefield
