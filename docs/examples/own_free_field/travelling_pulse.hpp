#pragma once

// A free-field model of one's own: an SV wave that comes up vertically through a homogeneous half-space and
// is reflected at its free surface, in closed form. With f the incident velocity at the surface and d the
// depth,
//
//     v_x = f(t + d/c_s) + f(t - d/c_s),      s_xy = -rho c_s (f(t + d/c_s) - f(t - d/c_s)),
//
// the rates with f' in place of f. The upgoing wave has the first terms alone.

#include <cmath>
#include <numbers>

struct Motion {
  double velocity = 0.0; ///< v_x, m/s
  double stress = 0.0;   ///< s_xy, Pa
  double velocity_rate = 0.0;
  double stress_rate = 0.0;
};

class TravellingPulse {
public:
  TravellingPulse(double density, double speed) : speed_(speed), impedance_(density * speed) {}

  /// Motion at a depth below the free surface, m, and a time, s.
  Motion at(double depth, double time, bool with_reflection) const {
    const double up = time + depth / speed_;
    const double down = time - depth / speed_;
    const double r = with_reflection ? 1.0 : 0.0;
    return {f(up) + r * f(down), -impedance_ * (f(up) - r * f(down)), rate(up) + r * rate(down),
            -impedance_ * (rate(up) - r * rate(down))};
  }

private:
  /// A Ricker pulse of 3 Hz that reaches the surface at 0.8 s, 0.1 m/s.
  static double f(double t) { return 0.1 * (1.0 - 2.0 * a(t)) * std::exp(-a(t)); }
  static double rate(double t) {
    return 0.1 * 2.0 * std::numbers::pi * std::numbers::pi * 9.0 * (t - 0.8) * (2.0 * a(t) - 3.0) *
           std::exp(-a(t));
  }
  static double a(double t) { return std::pow(std::numbers::pi * 3.0 * (t - 0.8), 2); }

  double speed_;
  double impedance_;
};
