#pragma once

// Traceless symmetric tensors of the plane by their two numbers, and the split of stress and strain into an
// in-plane mean and such a tensor:
//
//     t = [[d, s], [s, -d]],    t:u = 2 (t_d u_d + t_s u_s).
//
// Real is double for one point, or Lanes for four.

#include "base/lanes.hpp"

namespace tremolo::materials {

/// A traceless symmetric tensor of the plane.
template <typename Real>
struct DeviatorOf {
  Real d{}; ///< the xx component, and minus the yy component
  Real s{}; ///< the xy component
};
using Deviator = DeviatorOf<double>;

template <typename Real>
DeviatorOf<Real> operator+(const DeviatorOf<Real>& a, const DeviatorOf<Real>& b) {
  return {a.d + b.d, a.s + b.s};
}
template <typename Real>
DeviatorOf<Real> operator-(const DeviatorOf<Real>& a, const DeviatorOf<Real>& b) {
  return {a.d - b.d, a.s - b.s};
}
template <typename Factor, typename Real>
DeviatorOf<Real> operator*(const Factor& factor, const DeviatorOf<Real>& a) {
  return {factor * a.d, factor * a.s};
}

/// a:b
template <typename Real>
Real contract(const DeviatorOf<Real>& a, const DeviatorOf<Real>& b) {
  return 2.0 * (a.d * b.d + a.s * b.s);
}
/// sqrt(a:a)
template <typename Real>
Real norm(const DeviatorOf<Real>& a) {
  return sqrt(contract(a, a));
}

} // namespace tremolo::materials
