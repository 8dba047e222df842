#pragma once

// Dilatancy D of PM4Sand, the plastic volumetric strain (contraction positive) per loading index
// (Boulanger & Ziotopoulou 2017, sections 2.7 and 2.10). With the loading direction n and the fabric z,
//
//     a_z = <-z:n>/(sqrt2 z_max),  C_zin1 = 1 - exp(-2 |z_in:n - z:n|/z_max),
//     M_dR = M_d/max(1, 1 + 2 a_z (1 - C_zin1)),  alpha_x:n = (M_x - m)/sqrt2
//
// decide: beyond the rotated dilatancy surface, alpha:n >= alpha_dR:n, the sand dilates,
//
//     D_nr = A_d (alpha_d - alpha):n,   D_rot = A_d a_z (alpha_dR - alpha):n/C_DR,
//     A_d = A_do C_zin2/(1 + (z_cum^2/z_max) (1 - <-z:n>/(sqrt2 z_peak))^3 c_eps^2 C_pzp C_pmin C_zin1),
//
// otherwise it contracts, with X = (alpha_d - alpha):n,
//
//     D = min(A_dc ((alpha - alpha_in):n + C_in)^2, 1.5 A_do) X/(X + 0.16),
//     A_dc = A_do (1 + <z:n>)/(h_p C_dz),  h_p = h_po exp(-0.7 + 7 <0.5 - xi_R>^2).
//
// Near zero effective stress contraction fades (2 to 18 p_min) and dilation is forced (below 2 p_min).

#include "materials/pm4sand_surfaces.hpp"

namespace tremolo::materials::pm4 {

/// What modulus and dilatancy share: products of state and loading direction at the present stress.
struct Direction {
  Deviator n;              ///< unit tensor
  double alpha_n = 0.0;    ///< alpha:n
  double z_n = 0.0;        ///< z:n
  double alpha_in_n = 0.0; ///< alpha_in:n, apparent
};

inline Direction direction(const State& state, Deviator n) {
  return {n, contract(state.alpha, n), contract(state.z, n), contract(state.alpha_in.deviator(), n)};
}

struct Dilatancy {
  double D = 0.0;
  bool contracts = false;
};

/// C_zpk2, below 1
inline double peak_fabric(const State& state) {
  return std::min(state.z_peak / (state.z_cum + 0.01 * state.z_max), 1.0 - 1e-12);
}

/// 1 - exp(-2 |z_in:n - z:n|/z_max)
inline double fabric_since_reversal(const State& state, const Direction& to) {
  const double change = contract(state.z_in, to.n) - to.z_n;
  return change == 0.0 ? 0.0 : 1.0 - std::exp(-2.0 * std::abs(change) / state.z_max);
}

inline double dilation(const Pm4Sand& law, const State& state, const Surfaces& surface, const Direction& to,
                       double p, double M_cur, double a_z, double C_zin1, double M_dR) {
  const double ratio = 2.5 * p / state.p_zp;
  const double ratio2 = ratio * ratio;
  const double C_pzp = 1.0 / (1.0 + ratio2 * ratio2 * ratio);
  const double small = 10.0 * state.p_min / p;
  const double C_pmin = 1.0 / (1.0 + small * small);
  const double u = (state.z_cum - state.z_peak) / (3.0 * state.z_max);
  const double C_zin2 = (1.0 + C_zin1 * u) / (1.0 + 3.0 * C_zin1 * u);
  const double unaligned = 1.0 - std::max(-to.z_n, 0.0) / (sqrt2 * state.z_peak);
  const double strain = state.z_cum * state.z_cum / state.z_max * unaligned * unaligned * unaligned;
  const double A_d = state.A_do * C_zin2 / (1.0 + strain * law.c_eps * law.c_eps * C_pzp * C_pmin * C_zin1);

  const double D_nr = A_d * ((surface.M_d - law.m) / sqrt2 - to.alpha_n);
  const double D_rot = A_d * a_z * ((M_dR - law.m) / sqrt2 - to.alpha_n) / law.C_DR;
  double D = D_nr;
  if (D_nr > D_rot) {
    const double below = std::max(surface.M_b - M_cur, 0.0);
    D += (D_rot - D_nr) * below / (below + 0.01);
  }
  if (p <= 2.0 * state.p_min) {
    const double forced = 3.5 * state.A_do * std::max(surface.M_b - surface.M_d, 0.0);
    D = std::min(D, -forced * (2.0 * state.p_min - p) / state.p_min);
  }
  return D;
}

inline double contraction(const Pm4Sand& law, const State& state, const Surfaces& surface,
                          const Direction& to, double p) {
  const double fading = std::min((p - 2.0 * state.p_min) / (16.0 * state.p_min), 1.0);
  if (fading <= 0.0) {
    return 0.0;
  }
  const double dense = std::max(0.5 - surface.xi_R, 0.0);
  const double h_p = law.h_po * std::exp(-0.7 + 7.0 * dense * dense);
  const double C_rot2 = 1.0 - peak_fabric(state);
  const double z_max = state.z_max;
  const double C_dz =
      std::max((1.0 - C_rot2 * sqrt2 * state.z_peak / z_max) * z_max / (z_max + C_rot2 * state.z_cum),
               1.0 / (1.0 + 0.5 * z_max));
  const double aligned = std::max(to.z_n, 0.0);
  const double A_dc = state.A_do * (1.0 + aligned) / (h_p * C_dz);
  const double C_in = sqrt2 * aligned / z_max;
  const double X = (surface.M_d - law.m) / sqrt2 - to.alpha_n;
  const double travelled = to.alpha_n - to.alpha_in_n + C_in;
  return fading * std::min(A_dc * travelled * travelled, 1.5 * state.A_do) * X / (X + 0.16);
}

/// @param p  Pa, at least p_min
inline Dilatancy dilatancy(const Pm4Sand& law, const State& state, const Surfaces& surface,
                           const Direction& to, double p, double M_cur) {
  const double a_z = std::max(-to.z_n, 0.0) / (sqrt2 * state.z_max);
  const double C_zin1 = a_z > 0.0 ? fabric_since_reversal(state, to) : 0.0;
  const double M_dR = surface.M_d / std::max(1.0, 1.0 + 2.0 * a_z * (1.0 - C_zin1));
  if ((M_dR - law.m) / sqrt2 > to.alpha_n) {
    return {contraction(law, state, surface, to, p), true};
  }
  const double full_C_zin1 = a_z > 0.0 ? C_zin1 : fabric_since_reversal(state, to);
  return {dilation(law, state, surface, to, p, M_cur, a_z, full_C_zin1, M_dR), false};
}

} // namespace tremolo::materials::pm4
