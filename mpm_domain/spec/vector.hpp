#pragma once

#include "coupler/eq6/boundary_traction.hpp"

namespace tremolo::mpm_domain {

using eq6::Vector;

inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}

/// a . a
inline double square(const Vector& a) {
  return dot(a, a);
}

/// The out-of-plane component of a x b.
inline double cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}

} // namespace tremolo::mpm_domain
