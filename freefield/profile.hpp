#pragma once

#include "materials/elastic/elasticity.hpp"
#include "materials/law/law.hpp"
#include "materials/relaxation/constant_damping.hpp"
#include "materials/water/pore_water.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tremolo::freefield {

struct Layer {
  double thickness = 0.0;     ///< m
  materials::Elasticity soil; ///< at small strain
  double damping_ratio = 0.0; ///< of critical, [0, 1); what it means at which frequency is the Damping's
  std::optional<materials::Law> law = std::nullopt; ///< absent: linear elastic; its constants are `soil`
  /// Set for a layer below the water table: `soil` is then the skeleton, with the density of grains and
  /// water.
  std::optional<materials::PoreSpace> pores = std::nullopt;
  /// Fraction of the P-wave modulus that relaxes under constant damping where grains and water are one
  /// material: G/M.
  double relaxing_share_p = 1.0;
};

/// The water table of a profile, at an interface of its layers, at the surface or above it.
struct WaterTable {
  double level = 0.0; ///< y, m
  materials::PoreFluid fluid;
};

/// A layer of soil that follows a law, whose elastic constants become the layer's.
Layer layer_of(double thickness, const materials::Law& law, double damping_ratio = 0.0);

/// Soil layers from top to bottom on an elastic half-space.
struct Profile {
  double surface_level = 0.0; ///< y of the free surface, m
  std::vector<Layer> layers;
  materials::Elasticity half_space;
  /// m/s2, downwards: laws start from the effective stress syy = -rho g depth + pore pressure, sxx = szz =
  /// K0 syy
  double gravity = 0.0;
  std::optional<WaterTable> water = std::nullopt;

  /// y of the base, m: where the layers end and the half-space begins.
  double base_level() const;
  /// Hydrostatic pore pressure at y where soil is wet, Pa; 0 above the table, and without one.
  double hydrostatic_pressure(double y) const;
};

/// c = alpha rho + beta E per layer, alpha rho on the velocity relative to the rock below (base_motion.hpp),
/// which gives the layer's damping ratio at both frequencies.
struct RayleighDamping {
  double first_frequency_hz = 0.0;
  double second_frequency_hz = 0.0;
};

/// sigma = E (eps + beta d eps/dt) per layer: the layer's damping ratio at the reference frequency, growing
/// linearly with frequency.
struct KelvinVoigtDamping {
  double reference_frequency_hz = 0.0;
};

/// The layer's ratio in a band of frequencies, by relaxation mechanisms.
using materials::ConstantDamping;

using Damping = std::variant<KelvinVoigtDamping, RayleighDamping, ConstantDamping>;

/// Damping coefficients of a layer: alpha (1/s) on mass, beta (s) on stiffness.
struct DampingCoefficients {
  double alpha = 0.0;
  double beta = 0.0;
};

/// The coefficients that give a layer its damping ratio; both zero for a ratio of zero, whatever the damping,
/// and for constant damping.
DampingCoefficients coefficients(const Damping& damping, double ratio);

/// The mechanisms that give a layer its damping ratio; none unless damping is constant.
materials::Relaxation relaxation(const Damping& damping, double ratio);

/// @throws std::invalid_argument naming the layer, the quantity, its value and the allowed range
void validate(const Profile& profile);
void validate(const Damping& damping);

} // namespace tremolo::freefield
