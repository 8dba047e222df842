#pragma once

#include "materials/relaxation/constant_damping.hpp"
#include "wavefield/layers/half_space.hpp"

#include <array>
#include <complex>
#include <optional>
#include <string_view>
#include <vector>

namespace tremolo::wavefield {

/// Complex modulus of a soil with damping ratio xi at s = i omega, with G its undamped modulus; likewise for
/// the P-wave modulus.
enum class DampingModel {
  none,         ///< G
  hysteretic,   ///< G (1 + 2 i xi)
  shake,        ///< G (1 - 2 xi^2 + 2 i xi sqrt(1 - xi^2)), so that |G*| = G (SHAKE91)
  kelvin_voigt, ///< G (1 + 2 xi s / omega_0): xi at the reference frequency, growing in proportion to
                ///< frequency
  kjartansson,  ///< G (s / omega_0)^(2 atan(2 xi) / pi): constant Q and causal (Kjartansson 1979)
  constant,     ///< what soil of relaxation mechanisms has (materials/relaxation): xi in a band, and causal
  rayleigh      ///< G (1 + beta s), and rho (1 + alpha/s) on the velocity relative to the outcrop: xi at two
                ///< frequencies; at vertical incidence alone
};

struct Damping {
  DampingModel model = DampingModel::none;
  /// omega_0 / (2 pi) of kelvin_voigt, kjartansson and constant; unused by the others
  double reference_hz = 0.0;
  materials::DampingBand band = {};          ///< of constant
  std::array<double, 2> frequencies_hz = {}; ///< of rayleigh, at which it has its ratio
};

/// xi = alpha / (2 w) + beta w / 2 of Rayleigh's damping, equal at both frequencies.
struct RayleighFactors {
  double alpha = 0.0; ///< 1/s
  double beta = 0.0;  ///< s
};
RayleighFactors rayleigh_factors(const Damping& damping, double ratio);

/// A homogeneous, isotropic layer.
struct Layer {
  double thickness = 0.0;          ///< m
  double density = 0.0;            ///< kg/m3
  double vs = 0.0;                 ///< undamped shear wave speed, m/s
  double vp = 0.0;                 ///< undamped compressional wave speed, m/s
  double damping = 0.0;            ///< damping ratio xi of the shear modulus, 1
  std::optional<double> damping_p; ///< of the P-wave modulus; that of the shear modulus if not given
  /// Fraction of the P-wave modulus that relaxes under damping `constant`: in saturated soil G/M.
  double relaxing_share_p = 1.0;
};

/// Layers from the free surface down, on a half-space; without layers the half-space itself has the surface.
struct LayeredHalfSpace {
  std::vector<Layer> layers;
  HalfSpace half_space;
  double half_space_damping = 0.0; ///< damping ratio xi of both its moduli
  Damping damping;

  double thickness() const; ///< of all layers together, m
};

/// Moduli at one frequency, Pa.
struct ComplexModuli {
  std::complex<double> shear;  ///< G*
  std::complex<double> p_wave; ///< M* = lambda* + 2 G*
};

/// The moduli of one medium.
class MediumModuli {
public:
  /// The moduli of layer `index`, counted from the top; for index = layers.size() those of the half-space.
  MediumModuli(const LayeredHalfSpace& profile, std::size_t index);

  /// The models none, hysteretic and shake do not depend on s; for kjartansson s = 0 gives the undamped
  /// modulus.
  /// @param s  i omega + epsilon, 1/s, omega >= 0
  ComplexModuli at(std::complex<double> s) const;

private:
  /// An undamped modulus, Pa, and what damps it.
  struct Modulus {
    double value = 0.0;
    double ratio = 0.0;
    materials::Relaxation relaxation = {};
  };
  std::complex<double> factor(const Modulus& modulus, std::complex<double> s) const;

  Damping damping_;
  Modulus shear_, p_wave_;
};

/// Whether the moduli are the same at all frequencies above zero.
bool is_frequency_independent(DampingModel model);

/// Whether the damping ratio jumps to its conjugate across zero frequency: hysteretic and shake. Their answer
/// is not causal, and has tails before the arrival.
bool jumps_at_zero_frequency(DampingModel model);

/// Whether any damping ratio is above zero.
bool is_damped(const LayeredHalfSpace& profile);

std::string_view name(DampingModel model);

/// @throws std::invalid_argument naming layer, quantity, value and the allowed range; also where layers are
///         damped and the model is `none`
void validate(const LayeredHalfSpace& profile);

} // namespace tremolo::wavefield
