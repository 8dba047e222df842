#pragma once

#include <cstddef>
#include <vector>

namespace tremolo::wavefield {

/// Times start + i dt, i = 0 .. count-1, in s.
struct TimeGrid {
  double start = 0.0;
  double dt = 0.0;
  std::size_t count = 0;
};

/// The medium in which a point exactly on an interface lies: sxx, exx aside, and the strains jump there.
enum class Side { above, below };

/// A point of the soil, m: x to the right, y up.
struct Point {
  double x = 0.0;
  double y = 0.0;
  Side side = Side::above; ///< matters on an interface only
};

/// Quantities that sample() computes; the other series stay empty. Each costs one Fourier transform per
/// series.
struct Quantities {
  bool displacement = true;
  bool velocity = true;
  bool stress = true;
  bool strain = true;
  bool rates = true; ///< time derivatives, of velocity and stress, where these are asked for
};

/// The field at one point, one value a time of the grid. Stresses are the dynamic part, tension positive.
struct History {
  std::vector<double> ux, uy;                       ///< displacement, m
  std::vector<double> vx, vy;                       ///< particle velocity, m/s
  std::vector<double> sxx, syy, sxy;                ///< stress, Pa
  std::vector<double> exx, eyy, gxy;                ///< strain, gxy = dux/dy + duy/dx, 1
  std::vector<double> vx_rate, vy_rate;             ///< time derivatives of velocity, m/s2
  std::vector<double> sxx_rate, syy_rate, sxy_rate; ///< and of stress, Pa/s
};

enum class Part {
  total,   ///< incident and reflected waves: the free field
  incident ///< the incident upgoing wave alone, as a transmitting base takes it; in the half-space only
};

} // namespace tremolo::wavefield
