#pragma once

// Symmetric tensors without out-of-plane shear, split into mean and deviator. The deviator is kept by its
// components in an orthonormal basis of the deviatoric tensors,
//
//     a = (xx - yy)/sqrt 2,    b = sqrt(3/2) (zz - mean),    c = sqrt 2 xy,
//
// so that a contraction s:t is a dot product and trace-freeness holds by construction. Real is double for one
// point, or Lanes for four.

#include "base/lanes.hpp"

#include <cmath>

namespace tremolo::materials {

using tremolo::choose; // beside that of deviators

/// A deviatoric tensor in three dimensions.
template <typename Real>
struct Deviator3Of {
  Real a{};
  Real b{};
  Real c{};

  /// The tensor component xy.
  Real xy() const { return c * std::sqrt(0.5); }
};
using Deviator3 = Deviator3Of<double>;

template <typename Real>
Deviator3Of<Real> operator+(const Deviator3Of<Real>& l, const Deviator3Of<Real>& r) {
  return {l.a + r.a, l.b + r.b, l.c + r.c};
}
template <typename Real>
Deviator3Of<Real> operator-(const Deviator3Of<Real>& l, const Deviator3Of<Real>& r) {
  return {l.a - r.a, l.b - r.b, l.c - r.c};
}
template <typename Factor, typename Real>
Deviator3Of<Real> operator*(const Factor& x, const Deviator3Of<Real>& d) {
  return {x * d.a, x * d.b, x * d.c};
}

/// l where a mask holds, r elsewhere.
template <typename Mask, typename Real>
Deviator3Of<Real> choose(const Mask& mask, const Deviator3Of<Real>& l, const Deviator3Of<Real>& r) {
  return {choose(mask, l.a, r.a), choose(mask, l.b, r.b), choose(mask, l.c, r.c)};
}

/// l : r
template <typename Real>
Real dot(const Deviator3Of<Real>& l, const Deviator3Of<Real>& r) {
  return l.a * r.a + l.b * r.b + l.c * r.c;
}

/// sqrt(d : d)
template <typename Real>
Real norm(const Deviator3Of<Real>& d) {
  return sqrt(dot(d, d));
}

/// A symmetric tensor: a third of its trace, and its deviator.
template <typename Real>
struct MeanAndDeviatorOf {
  Real mean{};
  Deviator3Of<Real> deviator;
};
using MeanAndDeviator = MeanAndDeviatorOf<double>;

/// The split of a tensor given by its components; xy is the tensor component.
template <typename Real>
MeanAndDeviatorOf<Real> split(const Real& xx, const Real& yy, const Real& zz, const Real& xy) {
  const Real mean = (xx + yy + zz) / 3.0;
  return {mean, {(xx - yy) * std::sqrt(0.5), (zz - mean) * std::sqrt(1.5), xy * std::sqrt(2.0)}};
}

/// Components of a tensor; xy is the tensor component.
template <typename Real>
struct TensorComponentsOf {
  Real xx{};
  Real yy{};
  Real zz{};
  Real xy{};
};

/// The inverse of split().
template <typename Real>
TensorComponentsOf<Real> components(const MeanAndDeviatorOf<Real>& t) {
  const Real zz = t.deviator.b * std::sqrt(2.0 / 3.0);
  const Real half_difference = t.deviator.a * std::sqrt(0.5);
  const Real middle = t.mean - 0.5 * zz;
  return {middle + half_difference, middle - half_difference, t.mean + zz, t.deviator.xy()};
}

} // namespace tremolo::materials
