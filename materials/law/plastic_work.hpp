#pragma once

#include "materials/elastic/elasticity.hpp"

namespace tremolo::materials {

/// Stress of a point, or a change of it, Pa; out-of-plane shear is zero.
struct Stress {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double xy = 0.0;
};

/// Strain increment of a point; gxy is the engineering shear.
struct StrainIncrement {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double gxy = 0.0;
};

/// sigma : D^-1 d, the work of a stress on the strain that belongs to a change d of elastic stress, J/m3.
inline double work_on_strain(const Stress& s, const Stress& d, const Elasticity& elastic) {
  const double products = s.xx * d.xx + s.yy * d.yy + s.zz * d.zz + 2.0 * s.xy * d.xy;
  const double traces = (s.xx + s.yy + s.zz) * (d.xx + d.yy + d.zz);
  return (1.0 + elastic.poisson) / elastic.young * products - elastic.poisson / elastic.young * traces;
}

/// Plastic work of a step with the mean of first and last stress, as the trapezoidal rule takes the whole
/// work of the step: total = elastic + plastic then holds without remainder. J/m3
/// @param trial    elastic stress at the end of a step of strain de
/// @param relaxed  what plastic flow takes from it
inline double plastic_work(const Elasticity& elastic, const StrainIncrement& de, const Stress& trial,
                           const Stress& relaxed) {
  const double shear = elastic.shear_modulus();
  const double pressure = elastic.lame() * (de.xx + de.yy + de.zz);
  const Stress mean = {trial.xx - 0.5 * (pressure + relaxed.xx) - shear * de.xx,
                       trial.yy - 0.5 * (pressure + relaxed.yy) - shear * de.yy,
                       trial.zz - 0.5 * (pressure + relaxed.zz) - shear * de.zz,
                       trial.xy - 0.5 * (shear * de.gxy + relaxed.xy)};
  return work_on_strain(mean, relaxed, elastic);
}

} // namespace tremolo::materials
