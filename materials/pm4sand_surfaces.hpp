#pragma once

// State surfaces and elasticity of PM4Sand. With the critical state line of Bolton (1986),
//
//     D_Rcs = R/(Q - ln(100 p/p_A)),    xi_R = D_Rcs - D_R,
//     M_b = M exp(-n_b xi_R),  M_d = M exp(n_d xi_R)          dense of critical, xi_R <= 0,
//     M_b = M exp(-n_b xi_R/4),  M_d = M exp(4 n_d xi_R)      loose of critical,
//     G = G_o p_A sqrt(p/p_A) C_SR (1 + zeta)/(1 + C_GD zeta),  zeta = z_cum/z_max,
//     C_SR = 1 - 0.5 min(1, (M_cur/M_b)^4),  K = 2 (1 + nu)/(3 (1 - 2 nu)) G,
//
// and after shaking both times F_sed = min(1, F_sed,min + (1 - F_sed,min) p/(20 p_sed)),
// p_sed = p_sedo z_cum/(z_cum + z_max) <1 - M_cur/M_d>^(1/4). (Boulanger & Ziotopoulou 2017, sections 2.2,
// 2.5, 2.11; the cap on C_SR is that of later versions.) The pressure is at least p_min everywhere.

#include "materials/pm4sand.hpp"
#include "materials/pm4sand_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::materials::pm4 {

inline constexpr double sqrt2 = std::numbers::sqrt2;

struct Surfaces {
  double xi_R = 0.0; ///< relative state parameter index
  double M_b = 0.0;  ///< bounding
  double M_d = 0.0;  ///< dilatancy
};

/// @param p  Pa, at least p_min
/// @param volumetric_strain  since the start, compression positive
inline Surfaces surfaces(const Pm4Sand& law, double p, double volumetric_strain) {
  const double void_range = law.e_max - law.e_min;
  const double e_0 = law.e_max - law.relative_density * void_range;
  const double D_R = law.relative_density + (1.0 + e_0) * volumetric_strain / void_range;
  // Beyond crushing, where the line has no value, the soil is as loose of critical as a soil can be.
  const double depth = std::max(law.Q - std::log(100.0 * p / law.p_A), 0.1);
  const double xi_R = law.R / depth - D_R;
  const double b = xi_R > 0.0 ? 0.25 : 1.0;
  const double d = xi_R > 0.0 ? 4.0 : 1.0;
  return {xi_R, law.M * std::exp(-law.n_b * b * xi_R), law.M * std::exp(law.n_d * d * xi_R)};
}

/// M_cur of a stress, its ratio with the pressure p (Pa).
inline double stress_ratio(Deviator s, double p) {
  return sqrt2 * norm(s) / p;
}

/// F_sed, the part of the stiffness that is left after shaking.
inline double sedimentation(const Pm4Sand& law, const State& state, double p, double M_cur, double M_d) {
  const double below = 1.0 - M_cur / M_d;
  if (below <= 0.0) {
    return 1.0;
  }
  const double p_sed = law.p_sedo * state.z_cum / (state.z_cum + state.z_max) * std::sqrt(std::sqrt(below));
  return std::min(1.0, law.F_sed_min + (1.0 - law.F_sed_min) * p / std::max(20.0 * p_sed, 1e-12 * p));
}

/// G, Pa.
/// @param p  Pa, at least p_min
inline double shear_modulus(const Pm4Sand& law, const State& state, const Surfaces& surface, double p,
                            double M_cur) {
  const double ratio2 = (M_cur * M_cur) / (surface.M_b * surface.M_b);
  const double C_SR = 1.0 - 0.5 * std::min(1.0, ratio2 * ratio2);
  const double fabric = (state.z_max + state.z_cum) / (state.z_max + law.C_GD * state.z_cum);
  const double G = law.G_o * std::sqrt(law.p_A * p) * C_SR * fabric;
  return law.post_shake ? G * sedimentation(law, state, p, M_cur, surface.M_d) : G;
}

} // namespace tremolo::materials::pm4
