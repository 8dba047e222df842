#pragma once

// Traceless symmetric tensors of the plane by their two numbers, and the split of stress and strain into an
// in-plane mean and such a tensor:
//
//     t = [[d, s], [s, -d]],    t:u = 2 (t_d u_d + t_s u_s).

#include <cmath>

namespace tremolo::materials {

/// A traceless symmetric tensor of the plane.
struct Deviator {
  double d = 0.0; ///< the xx component, and minus the yy component
  double s = 0.0; ///< the xy component
};

inline Deviator operator+(Deviator a, Deviator b) {
  return {a.d + b.d, a.s + b.s};
}
inline Deviator operator-(Deviator a, Deviator b) {
  return {a.d - b.d, a.s - b.s};
}
inline Deviator operator*(double factor, Deviator a) {
  return {factor * a.d, factor * a.s};
}

/// a:b
inline double contract(Deviator a, Deviator b) {
  return 2.0 * (a.d * b.d + a.s * b.s);
}
/// sqrt(a:a)
inline double norm(Deviator a) {
  return std::sqrt(contract(a, a));
}

} // namespace tremolo::materials
