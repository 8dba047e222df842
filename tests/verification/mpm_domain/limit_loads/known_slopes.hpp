#pragma once

// Slopes whose limits are published. In undrained clay, strength c without friction, a slope of height H
// stands by itself where c > N gamma H with the stability numbers N of Taylor (1948, Fundamentals of Soil
// Mechanics, fig. 16.26). With friction Griffiths and Lane (1999, Geotechnique 49, 387-403, examples 1 and 2)
// give the factor F by which c and tan phi can be divided: 1.4 for slopes of 2 to 1, c = 0.05 gamma H and
// phi = 20 degrees, on their base and on half their height of the same soil.

#include "tests/verification/mpm_domain/limit_loads/slope.hpp"
#include "tests/verification/mpm_domain/limit_loads/static_limit.hpp"

#include <cmath>
#include <ostream>
#include <stdexcept>

namespace tremolo::mpm_domain::test {

/// N of 30, 45 and 60 degrees and depth factors of 1, 1.5 and 2.
inline double taylor_number(const Slope& slope) {
  const auto of_depth = [&](double one, double one_and_a_half, double two) {
    if (slope.depth_factor == 1.0)
      return one;
    if (slope.depth_factor == 1.5)
      return one_and_a_half;
    if (slope.depth_factor == 2.0)
      return two;
    throw std::out_of_range("depth factors of the chart read here: 1, 1.5, 2");
  };
  if (slope.angle_deg == 30.0)
    return of_depth(0.133, 0.164, 0.172);
  if (slope.angle_deg == 45.0)
    return of_depth(0.164, 0.174, 0.177);
  if (slope.angle_deg == 60.0)
    return of_depth(0.191, 0.191, 0.191);
  throw std::out_of_range("angles of the chart read here: 30, 45, 60 degrees");
}

struct ClaySlope {
  Slope slope;
  double poisson;
  Dilatation dilatation = Dilatation::cell;

  friend void PrintTo(const ClaySlope& s, std::ostream* out) {
    *out << s.slope.angle_deg << " deg, depth factor " << s.slope.depth_factor << ", cells of "
         << s.slope.cell_size << " m, nu " << s.poisson;
  }
};

/// @param strength  over that of Taylor's chart
inline Spec spec_of(const ClaySlope& of, double strength) {
  constexpr double density = 1800.0;
  Spec spec = spec_of(
      of.slope, perfectly_plastic({density, 20e6, of.poisson},
                                  strength * taylor_number(of.slope) * density * gravity * height, 0.0));
  spec.scheme.dilatation = of.dilatation;
  return spec;
}
inline bool stands(const ClaySlope& of, double strength) {
  // On deep ground slopes of 30 and 45 degrees take up to 21 s to come to rest (the finest mesh at
  // 45 degrees and nu = 0.495 takes 47 s), all others less than 5 s.
  const bool slow = of.slope.angle_deg < 60.0 && of.slope.depth_factor > 1.0;
  return carries_its_weight(spec_of(of, strength), slow ? 60.0 : 10.0);
}

inline constexpr double griffiths_and_lane = 1.4;

struct SandySlope {
  double depth_factor;
  double cell_size; ///< m
  double poisson;

  friend void PrintTo(const SandySlope& s, std::ostream* out) {
    *out << "depth factor " << s.depth_factor << ", cells of " << s.cell_size << " m, nu " << s.poisson;
  }
};

inline Spec spec_of(const SandySlope& of, double factor) {
  constexpr double density = 2000.0;
  return spec_of({std::atan(0.5) / degree, of.depth_factor, of.cell_size},
                 perfectly_plastic({density, 100e6, of.poisson}, 0.05 * density * gravity * height / factor,
                                   std::atan(std::tan(20.0 * degree) / factor)));
}
/// @param share  of Griffiths and Lane's factor, by which the strength is divided
inline bool stands(const SandySlope& of, double share) {
  // Those that stand come to rest within 1 s.
  return carries_its_weight(spec_of(of, share * griffiths_and_lane), 5.0);
}

} // namespace tremolo::mpm_domain::test
