#pragma once

// The affine velocity C = B D^-1 of a particle, whose moment B is what it keeps (particles.hpp).

#include "mpm_domain/domain.hpp"
#include "mpm_domain/grid/box_average.hpp"

#include <cmath>

namespace tremolo::test_support {

/// d v_a / d x_b, 1/s
struct AffineVelocity {
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;
};

/// D of a particle's weights, which is diagonal, m2: sum S (x_i - x)^2 and sum S (y_i - y)^2.
inline Vector second_moments(const mpm_domain::Domain& domain, const mpm_domain::Particles& p,
                             std::size_t k) {
  if (domain.mesh) {
    const auto d = mpm_domain::second_moments(*domain.mesh, mpm_domain::box_of(p, k));
    return {d.x, d.y};
  }
  const auto moment = [](double x, const mpm_domain::Axis& axis, double half_side) {
    const double position = axis.cells(x);
    const mpm_domain::HalfSide<double> box(half_side, axis);
    return mpm_domain::CellWeights<double>(position - std::floor(position), axis, box).second_moment;
  };
  const Vector half = mpm_domain::half_sides(p, k);
  return {moment(p.x[k], domain.x_axis(), half.x), moment(p.y[k], domain.y_axis(), half.y)};
}

inline void set_affine_velocity(const mpm_domain::Domain& domain, mpm_domain::Particles& p, std::size_t k,
                                const AffineVelocity& c) {
  const Vector d = second_moments(domain, p, k);
  p.bxx[k] = c.xx * d.x;
  p.bxy[k] = c.xy * d.y;
  p.byx[k] = c.yx * d.x;
  p.byy[k] = c.yy * d.y;
}

inline AffineVelocity affine_velocity(const mpm_domain::Domain& domain, const mpm_domain::Particles& p,
                                      std::size_t k) {
  const Vector d = second_moments(domain, p, k);
  return {p.bxx[k] / d.x, p.bxy[k] / d.y, p.byx[k] / d.x, p.byy[k] / d.y};
}

} // namespace tremolo::test_support
