#pragma once

#include "freefield/column.hpp"
#include "freefield/fe/fe_newton.hpp"
#include "freefield/fe/scalar_column.hpp"
#include "freefield/profile.hpp"

namespace tremolo::freefield {

struct FeColumnSettings {
  double max_element_size = 0.0; ///< m; every layer is cut into equal elements no longer than this
  double time_step = 0.0;        ///< s
  Integrator integrator = Integrator::newmark;
  Damping damping;         ///< read only where a layer has a damping ratio
  double start_time = 0.0; ///< s; the column is at rest then
  BaseKind base = BaseKind::compliant;
  double hht_alpha = 0.0;                ///< of Newmark: Hilber, Hughes and Taylor's, in [-1/3, 0]
  Tangent tangent = Tangent::consistent; ///< read only with nonlinear layers and Newmark
  double newton_tolerance = 1e-8;        ///< largest force residual over the largest traction so far
};

/// What Newton's method has taken so far.
struct NewtonCounts {
  long iterations = 0;
  long halved_steps = 0;
};

} // namespace tremolo::freefield
