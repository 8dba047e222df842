#pragma once

// The general quadratic/hyperbolic backbone with a given strength (GQ/H), Groholski, Hashash, Kim, Musgrove,
// Harmon & Stewart (2016), J. Geotech. Geoenviron. Eng. 142(9), 04016042. With x = gamma/gamma_r and
// gamma_r = tau_max/G0,
//
//     tau/tau_max = 2 x / (1 + x + D),   D = sqrt((1 + x)^2 - 4 theta x),
//     theta(x)    = theta1 + theta2 theta4 x^theta5 / (theta3^theta5 + theta4 x^theta5) <= 1.
//
// The secant reduction of backbone.hpp and its slope follow as
//
//     r        = (x - 1 + D)/2 = 2 x (1 - theta) / (1 - x + D),
//     x dr/dx  = [x + x ((1 + x) - 2 (theta + x dtheta/dx))/D] / 2.
//
// The second form of r has no difference of nearly equal numbers for x < 1. theta1 = 1 at all strains is
// elastic and perfectly plastic, theta = 0 the hyperbola.

#include <cmath>

namespace tremolo::materials {

/// r = G0/G_secant - 1 of a backbone, and x dr/dx.
struct Reduction {
  double value = 0.0;
  double slope = 0.0;
};

/// theta1 to theta5 of GQ/H.
struct QuadraticShape {
  double first = 0.0;  ///< theta1, theta at zero strain, at most 1
  double second = 0.0; ///< theta2; theta1 + theta2, theta at large strain, at most 1
  double third = 1.0;  ///< theta3, positive
  double fourth = 1.0; ///< theta4, positive
  double fifth = 1.0;  ///< theta5, in [0.1, 3]

  /// @param x  |gamma|/gamma_r
  Reduction reduction(double x) const {
    const double power = fourth * std::pow(x, fifth);
    const double base = std::pow(third, fifth);
    const double share = power / (base + power);
    const double theta = first + second * share;
    const double theta_slope = second * fifth * share * (1.0 - share); // x dtheta/dx
    const double d = std::sqrt((1.0 + x) * (1.0 + x) - 4.0 * theta * x);
    const double r = x < 1.0 ? 2.0 * x * (1.0 - theta) / (1.0 - x + d) : 0.5 * (x - 1.0 + d);
    return {r, 0.5 * x * (1.0 + (1.0 + x - 2.0 * (theta + theta_slope)) / d)};
  }
};

/// Refuses a shape whose theta exceeds 1 or whose stress falls anywhere with growing strain.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const QuadraticShape& shape);

} // namespace tremolo::materials
