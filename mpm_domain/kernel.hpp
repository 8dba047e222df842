#pragma once

// uGIMP weights in one direction (Bardenhagen and Kober 2004): the hat function N of the grid averaged over
// the particle's box [x - l, x + l] with l <= h/2,
//
//     S_i = 1/(2l) int N_i dx,      G_i = dS_i/dx.
//
// The box touches at most the nodes base, base+1, base+2, base = floor((x - l - x0)/h). With d0 and d1 the
// distances from the box's ends to node base+1 as far as they lie left of it, and b what reaches beyond it,
//
//     S_0 = (d0^2 - d1^2)/(4 h l),  G_0 = -(d0 - d1)/(2 h l),
//     S_2 = b^2/(4 h l),            G_2 = b/(2 h l),            S_1 = 1 - S_0 - S_2,  G_1 = -G_0 - G_2.

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

/// Weights of three consecutive nodes.
struct Weights {
  int base = 0;
  double s[3]; ///< S
  double g[3]; ///< dS/dx, 1/m
  double d[3]; ///< node minus particle, m
};

/// A direction of the grid as the kernel sees it.
struct Axis {
  double origin = 0.0; ///< coordinate of node 0, m
  double h = 0.0;
  double half_size = 0.0; ///< l, m
};

inline Weights gimp_weights(double x, const Axis& axis) {
  Weights w;
  const double left = x - axis.half_size;
  const double cell = std::floor((left - axis.origin) / axis.h);
  w.base = static_cast<int>(cell);
  const double node = axis.origin + (cell + 1.0) * axis.h;
  const double d0 = node - left;
  const double reach = x + axis.half_size - node;
  const double d1 = std::max(-reach, 0.0);
  const double b = std::max(reach, 0.0);
  const double c = 0.5 / (axis.h * axis.half_size);
  w.s[0] = 0.5 * c * (d0 + d1) * (d0 - d1);
  w.s[2] = 0.5 * c * b * b;
  w.s[1] = 1.0 - w.s[0] - w.s[2];
  w.g[0] = -c * (d0 - d1);
  w.g[2] = c * b;
  w.g[1] = -w.g[0] - w.g[2];
  w.d[1] = node - x;
  w.d[0] = w.d[1] - axis.h;
  w.d[2] = w.d[1] + axis.h;
  return w;
}

/// Second moment sum_i S_i (x_i - x)^2, m2: APIC's inertia of the kernel. Never below l^2/3.
inline double second_moment(const Weights& w) {
  return w.s[0] * w.d[0] * w.d[0] + w.s[1] * w.d[1] * w.d[1] + w.s[2] * w.d[2] * w.d[2];
}

} // namespace tremolo::mpm_domain
