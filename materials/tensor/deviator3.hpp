#pragma once

// Symmetric tensors without out-of-plane shear, split into mean and deviator. The deviator is kept by its
// components in an orthonormal basis of the deviatoric tensors,
//
//     a = (xx - yy)/sqrt 2,    b = sqrt(3/2) (zz - mean),    c = sqrt 2 xy,
//
// so that a contraction s:t is a dot product and trace-freeness holds by construction.

#include <cmath>

namespace tremolo::materials {

/// A deviatoric tensor in three dimensions.
struct Deviator3 {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;

  /// The tensor component xy.
  double xy() const { return c * std::sqrt(0.5); }
};

inline Deviator3 operator+(const Deviator3& l, const Deviator3& r) {
  return {l.a + r.a, l.b + r.b, l.c + r.c};
}
inline Deviator3 operator-(const Deviator3& l, const Deviator3& r) {
  return {l.a - r.a, l.b - r.b, l.c - r.c};
}
inline Deviator3 operator*(double x, const Deviator3& d) {
  return {x * d.a, x * d.b, x * d.c};
}

/// l : r
inline double dot(const Deviator3& l, const Deviator3& r) {
  return l.a * r.a + l.b * r.b + l.c * r.c;
}

/// sqrt(d : d)
inline double norm(const Deviator3& d) {
  return std::sqrt(dot(d, d));
}

/// A symmetric tensor: a third of its trace, and its deviator.
struct MeanAndDeviator {
  double mean = 0.0;
  Deviator3 deviator;
};

/// The split of a tensor given by its components; xy is the tensor component.
inline MeanAndDeviator split(double xx, double yy, double zz, double xy) {
  const double mean = (xx + yy + zz) / 3.0;
  return {mean, {(xx - yy) * std::sqrt(0.5), (zz - mean) * std::sqrt(1.5), xy * std::sqrt(2.0)}};
}

/// Components of a tensor; xy is the tensor component.
struct TensorComponents {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double xy = 0.0;
};

/// The inverse of split().
inline TensorComponents components(const MeanAndDeviator& t) {
  const double zz = t.deviator.b * std::sqrt(2.0 / 3.0);
  const double half_difference = t.deviator.a * std::sqrt(0.5);
  const double middle = t.mean - 0.5 * zz;
  return {middle + half_difference, middle - half_difference, t.mean + zz, t.deviator.xy()};
}

} // namespace tremolo::materials
