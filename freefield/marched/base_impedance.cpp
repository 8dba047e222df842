// Waves that go down from a plane at whose points the fields depend on t - s x (Aki & Richards 2002,
// sec. 5.2): with q_p = sqrt(1/c_p^2 - s^2), q_s = sqrt(1/c_s^2 - s^2), K = s^2 + q_p q_s and e = rho s (2
// c_s^2 - 1/K),
//
//     Z = [ rho q_p/K     -e      ]      B = [ 2 rho q_p/K       0       ]
//         [     e     rho q_s/K   ]          [      0       2 rho q_s/K  ].
//
// Z does not depend on frequency, so that it is exact in time, and its antisymmetric part does no work. At s
// = 0 they are rho c_s and rho c_p, and twice these.

#include "freefield/marched/base_impedance.hpp"

#include "base/require.hpp"

#include <cmath>

namespace tremolo::freefield {

BaseImpedance base_impedance(const materials::Elasticity& half_space, double slowness_x) {
  const double s = slowness_x;
  const double vs = half_space.s_wave_speed();
  const double vp = half_space.p_wave_speed();
  require(s >= 0.0 && s * vp < 1.0, "horizontal slowness of the incident wave", s,
          "at least 0 and below 1/c_p of the half-space, " + shortest(1.0 / vp) + " s/m");
  const double qp = std::sqrt(1.0 / (vp * vp) - s * s);
  const double qs = std::sqrt(1.0 / (vs * vs) - s * s);
  const double k = s * s + qp * qs;
  const double x = half_space.density * qp / k;
  const double y = half_space.density * qs / k;
  const double e = half_space.density * s * (2.0 * vs * vs - 1.0 / k);
  BaseImpedance base;
  base.outgoing << x, -e, e, y;
  base.incident.diagonal() << 2.0 * x, 2.0 * y;
  return base;
}

} // namespace tremolo::freefield
