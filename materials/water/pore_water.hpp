#pragma once

// Soil whose pores are full of water: porosity n, grains of density rho_s that do not compress, water of
// density rho_f and bulk modulus K_f. With M the modulus p_modulus() of the skeleton, drained,
//
//     rho = (1 - n) rho_s + n rho_f,    rho_dry = (1 - n) rho_s,    Q = K_f / n,
//     undrained:  K_u = K + Q,  G_u = G,    c_u^2 = (M + Q)/rho                    (water moves with the
//     grains) without drag: c_1^2 > c_2^2, the eigenvalues of
//         [ (M + Q (1-n)^2)/m_s   Q n (1-n)/m_s ]
//         [ Q n (1-n)/m_f         Q n^2/m_f     ],    m_s = (1-n) rho_s,  m_f = n rho_f,
//     Darcy's drag on the unit of fluid volume: (n rho_f g/k) w,  k the hydraulic conductivity,
//     w decays with the rate lambda = n g rho / (k (1-n) rho_s),
//
// Zienkiewicz & Shiomi (1984), Int. J. Numer. Anal. Meth. Geomech. 8, 71-96; Verruijt (2010), An Introduction
// to Soil Dynamics, ch. 5. c_1 exceeds c_u by some ten per cent and bounds explicit steps.

#include "base/words.hpp"
#include "materials/elastic/elasticity.hpp"

namespace tremolo::materials {

/// The water in the pores.
struct PoreFluid {
  double density = 1000.0;              ///< rho_f, kg/m3
  double bulk_modulus = 2.2e9;          ///< K_f, Pa
  double cavitation_pressure = -90.0e3; ///< the lowest pore pressure there can be, gauge, Pa; at most 0
};

/// Behaviour of the water in a soil below the table.
enum class Drainage {
  coupled,   ///< it flows by Darcy's law: two velocities, one pore pressure
  undrained, ///< it moves with the grains: one velocity, one pore pressure
  drained    ///< its pressure stays hydrostatic: one velocity
};
constexpr auto words(Drainage) {
  return word_table<Drainage>(
      {{Drainage::coupled, "coupled"}, {Drainage::undrained, "undrained"}, {Drainage::drained, "drained"}});
}

/// The pores of a soil.
struct PoreSpace {
  double porosity = 0.0;      ///< n, 1, in (0, 1)
  double grain_density = 0.0; ///< rho_s, kg/m3
  double permeability = 0.0;  ///< hydraulic conductivity k, m/s; read only where drainage is coupled
  Drainage drainage = Drainage::coupled;

  /// e = n/(1 - n)
  double void_ratio() const { return porosity / (1.0 - porosity); }
};

/// n = e/(1 + e)
inline double porosity_of(double void_ratio) {
  return void_ratio / (1.0 + void_ratio);
}

/// Density of the soil without water, kg/m3.
double dry_density(const PoreSpace& pores);
/// Density of grains and water together, kg/m3.
double saturated_density(const PoreSpace& pores, const PoreFluid& water);
/// Buoyant density of a submerged soil: rho - rho_f, kg/m3.
double buoyant_density(const PoreSpace& pores, const PoreFluid& water);

/// Q = K_f/n, Pa: rise of pore pressure per unit of volume strain where no water leaves.
double pore_stiffness(const PoreSpace& pores, const PoreFluid& water);

/// The constants of the soil above the table: the skeleton's, with the dry density.
Elasticity dry(const Elasticity& skeleton, const PoreSpace& pores);
/// The constants that waves meet below the table: those of grains and water together, undrained, for total
/// stress; of `drained` soil the skeleton's. K0, which is one of effective stress, stays the skeleton's.
Elasticity saturated(const Elasticity& skeleton, const PoreSpace& pores, const PoreFluid& water);

/// Speeds of plane compression waves, m/s.
struct SaturatedSpeeds {
  double fast = 0.0;      ///< c_1, water and grains without drag
  double slow = 0.0;      ///< c_2, of the second kind, without drag
  double undrained = 0.0; ///< c_u, water locked to the grains
};

/// @param p_modulus  M of the skeleton, drained, Pa
SaturatedSpeeds saturated_speeds(double p_modulus, const PoreSpace& pores, const PoreFluid& water);

/// rho_f g/k, Pa s/m2: pressure gradient per unit of Darcy flux n w.
/// @param gravity  m/s2, with which the conductivity was measured
double flow_resistance(const PoreSpace& pores, const PoreFluid& water, double gravity);

/// lambda, 1/s: the rate at which drag takes the relative velocity of water and grains.
double drag_rate(const PoreSpace& pores, const PoreFluid& water, double gravity);

/// c_v = k/(rho_f g (1/M + n/K_f)), m2/s: how excess pore pressure spreads.
double consolidation_coefficient(double p_modulus, const PoreSpace& pores, const PoreFluid& water,
                                 double gravity);

/// @throws std::invalid_argument naming the quantity, its value and the allowed range
void validate(const PoreFluid& water);
/// @throws std::invalid_argument likewise; the permeability is looked at where drainage is coupled
void validate(const PoreSpace& pores);

} // namespace tremolo::materials
