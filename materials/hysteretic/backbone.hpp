#pragma once

// The modified Kondner-Zelasko (MKZ) backbone of soil in shear, Matasovic & Vucetic (1993), J. Geotech. Eng.
// 119(11), 1805-1822, with x = |gamma|/gamma_r:
//
//     tau(gamma)  = G0 gamma / (1 + beta x^s)
//     G/G0        = 1 / (1 + beta x^s)                                (secant)
//     Gt/G0       = (1 + beta (1 - s) x^s) / (1 + beta x^s)^2         (tangent)
//
// beta = s = 1 is the hyperbola of Kondner & Zelasko (1963) and Hardin & Drnevich (1972). Only s = 1 has a
// finite strength, G0 gamma_r/beta; with s < 1 the stress grows without bound, as gamma^(1-s).

#include <cmath>

namespace tremolo::materials {

/// Shear stress and its derivative with respect to the engineering shear strain, Pa.
struct ShearResponse {
  double stress = 0.0;
  double tangent = 0.0;
};

/// Monotonic shear stress against engineering shear strain.
struct Backbone {
  double shear_modulus = 0.0;    ///< G0, Pa
  double reference_strain = 0.0; ///< gamma_r, 1
  double beta = 1.0;             ///< 1
  double exponent = 1.0;         ///< s, 1, in [0.1, 1]

  /// beta |gamma/gamma_r|^s, what the secant modulus has lost over what is left of it
  double reduction(double strain) const {
    const double x = std::abs(strain) / reference_strain;
    return beta * (exponent == 1.0 ? x : std::pow(x, exponent));
  }
  /// tau, Pa, odd in the strain
  double stress(double strain) const { return secant(strain) * strain; }
  /// tau/gamma, Pa
  double secant(double strain) const { return shear_modulus * (1.0 / (1.0 + reduction(strain))); }
  /// d tau/d gamma, Pa
  double tangent(double strain) const { return response(strain).tangent; }
  /// Both from one power
  ShearResponse response(double strain) const {
    const double r = reduction(strain);
    const double left = 1.0 / (1.0 + r);
    const double secant = shear_modulus * left;
    return {secant * strain, secant * left * (1.0 + (1.0 - exponent) * r)};
  }
  /// Largest shear stress, Pa; infinite for s < 1
  double strength() const;
};

/// Refuses a backbone that is not positive, finite and increasing.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const Backbone& backbone);

/// Damping ratio of the symmetric loop of amplitude `strain` that the Masing rules draw from the backbone:
/// loop area over 4 pi times the energy tau gamma/2. Zero at zero strain, 2/pi at most.
double masing_damping(const Backbone& backbone, double strain);

} // namespace tremolo::materials
