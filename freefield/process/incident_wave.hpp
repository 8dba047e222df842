#pragma once

// The incident wave of a case at vertical incidence, upgoing in the half-space with speed c (c_s for SV, c_p
// for P):
//
//     v(y, t) = f(t - (y - y_reference)/c),    SV: v_x = v, s_xy = -rho c_s v,
//                                              P:  v_y = v, s_yy = -rho c_p v, s_xx = lambda/M s_yy.

#include "freefield/column.hpp"
#include "scene/case.hpp"
#include "scene/motion.hpp"

namespace tremolo::freefield {

class IncidentWave {
public:
  /// @throws motion::RecordError for a motion that cannot be read
  explicit IncidentWave(const scene::Case& scene);

  /// Velocity at a level y (m) of the half-space and a time (s).
  Velocity velocity(double y, double time) const;

  /// The full sample, with time derivatives, there.
  ColumnSample sample(double y, double time) const;

  /// When the motion begins at a level, s.
  double begin(double y) const { return motion_.begin() + delay(y); }

private:
  double delay(double y) const { return (y - y_reference_) / speed_; }

  scene::Motion motion_;
  scene::Wave wave_;
  materials::Elasticity half_space_;
  double speed_;
  double y_reference_;
};

} // namespace tremolo::freefield
