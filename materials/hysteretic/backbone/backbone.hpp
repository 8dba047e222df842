#pragma once

// Backbones of soil in shear, with x = |gamma|/gamma_r and the reduction r = G0/G_secant - 1:
//
//     tau(gamma)  = G0 gamma / (1 + r)
//     Gt          = G0 (1 + r - x dr/dx) / (1 + r)^2                    (tangent)
//
// The modified Kondner-Zelasko (MKZ) backbone, Matasovic & Vucetic (1993), J. Geotech. Eng. 119(11),
// 1805-1822, has
//
//     r = beta x^s.
//
// beta = s = 1 is the hyperbola of Kondner & Zelasko (1963) and Hardin & Drnevich (1972). Only s = 1 has a
// finite strength, G0 gamma_r/beta; with s < 1 the stress grows without bound, as gamma^(1-s).
//
// The backbone with a strength (GQ/H), quadratic_shape.hpp, reaches tau_max = G0 gamma_r.

#include "materials/hysteretic/backbone/loop_reduction.hpp"
#include "materials/hysteretic/backbone/quadratic_shape.hpp"
#include "materials/law/parameter.hpp"

#include <cmath>
#include <optional>
#include <span>

namespace tremolo::materials {

/// The numbers of a backbone in files: the reference strain, beta, the exponent and the strength.
std::span<const Parameter> backbone_parameters();

/// Shear stress and its derivative with respect to the engineering shear strain, Pa.
struct ShearResponse {
  double stress = 0.0;
  double tangent = 0.0;
};

/// Monotonic shear stress against engineering shear strain.
struct Backbone {
  double shear_modulus = 0.0;                         ///< G0, Pa
  double reference_strain = 0.0;                      ///< gamma_r, 1; of GQ/H tau_max/G0
  double beta = 1.0;                                  ///< of MKZ, 1
  double exponent = 1.0;                              ///< s of MKZ, 1, in [0.1, 1]
  std::optional<QuadraticShape> shape = std::nullopt; ///< of GQ/H; none: MKZ
  LoopReduction loops = {}; ///< what unloading keeps of the damping of the Masing rules

  /// r and x dr/dx
  Reduction loss(double strain) const {
    const double x = std::abs(strain) / reference_strain;
    if (shape)
      return shape->reduction(x);
    const double r = beta * (exponent == 1.0 ? x : std::pow(x, exponent));
    return {r, exponent * r};
  }
  /// r, what the secant modulus has lost over what is left of it
  double reduction(double strain) const { return loss(strain).value; }
  /// tau, Pa, odd in the strain
  double stress(double strain) const { return secant(strain) * strain; }
  /// tau/gamma, Pa
  double secant(double strain) const { return shear_modulus * (1.0 / (1.0 + reduction(strain))); }
  /// d tau/d gamma, Pa
  double tangent(double strain) const { return response(strain).tangent; }
  /// Both from one power
  ShearResponse response(double strain) const {
    const auto [r, slope] = loss(strain);
    const double left = 1.0 / (1.0 + r);
    const double secant = shear_modulus * left;
    return {secant * strain, secant * left * (1.0 + (r - slope))};
  }
  /// Largest shear stress, Pa; infinite for MKZ with s < 1
  double strength() const;
};

/// Refuses a backbone that is not positive, finite and increasing.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const Backbone& backbone);

/// Damping ratio of the symmetric loop of amplitude `strain` that the Masing rules draw from the backbone:
/// loop area over 4 pi times the energy tau gamma/2. Zero at zero strain, 2/pi at most.
double masing_damping(const Backbone& backbone, double strain);

/// Damping ratio of that loop with the backbone's reduction of loops, F times that of the Masing rules.
double loop_damping(const Backbone& backbone, double strain);

} // namespace tremolo::materials
