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

#include "materials/sand/pm4sand/pm4sand.hpp"
#include "materials/sand/pm4sand/pm4sand_state.hpp"
#include "materials/tensor/elementary.hpp"

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
  const double D_R = law.relative_density + law.density_rate * volumetric_strain;
  // Grains crush where the line goes to infinity (10 MPa by default): no sand is looser of critical than 2.
  const double depth = law.Q - elementary::log((100.0 / law.p_A) * p);
  const double xi_R = law.R / std::max(depth, 0.5 * law.R) - D_R;
  const double b = xi_R > 0.0 ? 0.25 : 1.0;
  const double d = xi_R > 0.0 ? 4.0 : 1.0;
  return {xi_R, law.M * elementary::exp(-law.n_b * b * xi_R), law.M * elementary::exp(law.n_d * d * xi_R)};
}

/// M_cur squared, of a stress.
inline double stress_ratio2(const Stress& stress) {
  return 2.0 * contract(stress.s, stress.s) / (stress.p * stress.p);
}

/// F_sed, the part of the stiffness that is left after shaking.
inline double sedimentation(const Pm4Sand& law, double z_cum, double z_max, double p, double M_cur,
                            double M_d) {
  const double below = 1.0 - M_cur / M_d;
  if (below <= 0.0 || z_cum == 0.0)
    return 1.0;
  const double p_sed = law.p_sedo * z_cum / (z_cum + z_max) * std::sqrt(std::sqrt(below));
  return std::min(1.0, law.F_sed_min + (1.0 - law.F_sed_min) * p / (20.0 * p_sed));
}

/// G, Pa.
/// @param p  Pa, at least p_min
inline double shear_modulus(const Pm4Sand& law, double z_cum, double z_max, const Surfaces& surface, double p,
                            double M_cur2) {
  const double ratio2 = M_cur2 / (surface.M_b * surface.M_b);
  const double C_SR = 1.0 - 0.5 * std::min(1.0, ratio2 * ratio2);
  const double fabric = (z_max + z_cum) / (z_max + law.C_GD * z_cum);
  const double G = law.G_o * std::sqrt(law.p_A * p) * C_SR * fabric;
  return law.post_shake ? G * sedimentation(law, z_cum, z_max, p, std::sqrt(M_cur2), surface.M_d) : G;
}

/// A point with its stress and what follows from it.
struct Site {
  const Pm4Sand& law;
  const Initial& start;
  const Memory* memory = nullptr;
  const Motion& now;
  Stress stress;
  double p = 0.0;      ///< pressure of the state surfaces, at least p_min, Pa
  double M_cur2 = 0.0; ///< M_cur squared
  Surfaces surface;
  double G = 0.0; ///< Pa
  double K = 0.0; ///< Pa
};

inline Site site(const Pm4Sand& law, const Initial& start, const Memory& memory, const Motion& now,
                 const Stress& stress) {
  Site here{law, start, &memory, now};
  here.stress = {std::max(stress.p, floor_pressure(start)), stress.s};
  here.p = std::max(stress.p, start.p_min);
  here.M_cur2 = stress_ratio2(here.stress);
  here.surface = surfaces(law, here.p, now.volumetric_strain);
  here.G = shear_modulus(law, now.z_cum, start.z_max, here.surface, here.p, here.M_cur2);
  here.K = law.bulk_ratio * here.G;
  return here;
}

} // namespace tremolo::materials::pm4
