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

#include <numbers>

namespace tremolo::materials::pm4 {

inline constexpr double sqrt2 = std::numbers::sqrt2;

template <typename Real>
struct SurfacesOf {
  Real xi_R{}; ///< relative state parameter index
  Real M_b{};  ///< bounding
  Real M_d{};  ///< dilatancy
};
using Surfaces = SurfacesOf<double>;

/// @param p  Pa, at least p_min
/// @param volumetric_strain  since the start, compression positive
template <typename Real>
SurfacesOf<Real> surfaces(const Pm4Sand& law, const Real& p, const Real& volumetric_strain) {
  const auto of = [](double value) { return constant<Real>(value); };
  const Real D_R = law.relative_density + law.density_rate * volumetric_strain;
  // Grains crush where the line goes to infinity (10 MPa by default): no sand is looser of critical than 2.
  const Real depth = law.Q - elementary::log((100.0 / law.p_A) * p);
  const Real xi_R = law.R / larger(of(0.5 * law.R), depth) - D_R;
  const Real b = choose(xi_R > 0.0, of(0.25), of(1.0));
  const Real d = choose(xi_R > 0.0, of(4.0), of(1.0));
  return {xi_R, law.M * elementary::exp(-law.n_b * b * xi_R), law.M * elementary::exp(law.n_d * d * xi_R)};
}

/// M_cur squared, of a stress.
template <typename Real>
Real stress_ratio2(const StressOf<Real>& stress) {
  return 2.0 * contract(stress.s, stress.s) / (stress.p * stress.p);
}

/// F_sed, the part of the stiffness that is left after shaking.
template <typename Real>
Real sedimentation(const Pm4Sand& law, const Real& z_cum, const Real& z_max, const Real& p, const Real& M_cur,
                   const Real& M_d) {
  const Real one = constant<Real>(1.0);
  const Real below = 1.0 - M_cur / M_d;
  const Real p_sed = law.p_sedo * z_cum / (z_cum + z_max) * sqrt(sqrt(positive(below)));
  const Real left = smaller(law.F_sed_min + (1.0 - law.F_sed_min) * p / (20.0 * p_sed), one);
  return choose((below <= 0.0) | (z_cum == 0.0), one, left);
}

/// G, Pa.
/// @param p  Pa, at least p_min
template <typename Real>
Real shear_modulus(const Pm4Sand& law, const Real& z_cum, const Real& z_max, const SurfacesOf<Real>& surface,
                   const Real& p, const Real& M_cur2) {
  const Real ratio2 = M_cur2 / (surface.M_b * surface.M_b);
  const Real C_SR = 1.0 - 0.5 * smaller(ratio2 * ratio2, constant<Real>(1.0));
  const Real fabric = (z_max + z_cum) / (z_max + law.C_GD * z_cum);
  const Real G = law.G_o * sqrt(law.p_A * p) * C_SR * fabric;
  if (!law.post_shake)
    return G;
  return G * sedimentation<Real>(law, z_cum, z_max, p, sqrt(M_cur2), surface.M_d);
}

/// A point with its stress and what follows from it.
template <typename Real>
struct SiteOf {
  const Pm4Sand& law;
  const InitialOf<Real>& start;
  const MemoryOf<Real>* memory = nullptr;
  const MotionOf<Real>& now;
  StressOf<Real> stress;
  Real p{};      ///< pressure of the state surfaces, at least p_min, Pa
  Real M_cur2{}; ///< M_cur squared
  SurfacesOf<Real> surface;
  Real G{}; ///< Pa
  Real K{}; ///< Pa
};
using Site = SiteOf<double>;

template <typename Real>
SiteOf<Real> site(const Pm4Sand& law, const InitialOf<Real>& start, const MemoryOf<Real>& memory,
                  const MotionOf<Real>& now, const StressOf<Real>& stress) {
  SiteOf<Real> here{law, start, &memory, now};
  here.stress = {larger(floor_pressure(start), stress.p), stress.s};
  here.p = larger(start.p_min, stress.p);
  here.M_cur2 = stress_ratio2(here.stress);
  here.surface = surfaces(law, here.p, now.volumetric_strain);
  here.G = shear_modulus(law, now.z_cum, start.z_max, here.surface, here.p, here.M_cur2);
  here.K = law.bulk_ratio * here.G;
  return here;
}

} // namespace tremolo::materials::pm4
