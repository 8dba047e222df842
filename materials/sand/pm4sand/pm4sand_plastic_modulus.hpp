#pragma once

// Plastic modulus of PM4Sand (Boulanger & Ziotopoulou 2017, section 2.8). With the distances
//
//     A_b = (alpha_b - alpha):n,  A_app = <(alpha - alpha_in):n>,  A_true = <(alpha - alpha_in_true):n>
//
// to the bounding surface and from the initial back stress ratios, apparent and true,
//
//     h = 1.5 G h_o C_ka / {p [exp(A_app) - 1 + C_g1] sqrt|A_b| [1 + 2 (z_peak/z_max) <A_b> sqrt(1 -
//     C_zpk2)]}, C_ka = 1 + C_kaf C_pzp2 C_zpk1/(1 + (2.5 A_true)^2),  C_g1 = h_o/200,
//
// times (A_app + C_g1)/(A_true + C_g1) where loading continues beyond the previous initial ratio's side, and
// K_p = 2/3 h p A_b: negative outside the bounding surface.

#include "materials/sand/pm4sand/pm4sand_dilatancy.hpp"

namespace tremolo::materials::pm4 {

struct PlasticModulus {
  Lanes h;   ///< rate of alpha towards the bounding surface, 1
  Lanes K_p; ///< Pa
};

/// C_ka, the stiffening by fabric under static shear stress
inline Lanes static_shear_factor(const Sites& at, const Lanes& A_true) {
  const Lanes below = at.memory->p_zp - at.p;
  const LaneMask stiffens = below > 0.0;
  if (!any(stiffens))
    return all(1.0);
  const Lanes C_pzp2 = below / (below + at.start.p_min);
  const Lanes C_zpk1 = at.now.z_peak / (at.now.z_cum + 0.2 * at.start.z_max);
  return choose(stiffens, 1.0 + at.law.C_kaf * C_pzp2 * C_zpk1 / (1.0 + 6.25 * A_true * A_true), all(1.0));
}

inline PlasticModulus plastic_modulus(const Sites& at, const Directions& to) {
  const Lanes A_b = (at.surface.M_b - at.law.m) / sqrt2 - to.alpha_n;
  const Lanes A_app = positive(to.alpha_n - to.alpha_in_n);
  const Lanes A_true = positive(to.alpha_n - contract(at.memory->alpha_in_true, to.n));
  const double C_g1 = at.law.h_o / 200.0;
  constexpr double nearest = 1e-6; // of A_b, where h would grow beyond all bounds
  const Lanes root = sqrt(larger(all(nearest), magnitude(A_b)));
  const Lanes fabric = 1.0 + 2.0 * (at.now.z_peak / at.start.z_max) * positive(A_b) * sqrt(1.0 - to.C_zpk2);
  const Lanes of_way = elementary::exp(A_app) - 1.0 + C_g1;
  const Lanes h = 1.5 * at.G * at.law.h_o * static_shear_factor(at, A_true) / (at.p * of_way * root * fabric);
  const LaneMask continues = to.alpha_n <= contract(at.memory->alpha_in_p, to.n);
  const Lanes faster = choose(continues, (A_app + C_g1) / (A_true + C_g1), all(1.0));
  return {faster * h, 2.0 / 3.0 * (faster * h) * at.p * A_b};
}

} // namespace tremolo::materials::pm4
