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

#include "materials/sand/pm4sand/pm4sand_surfaces.hpp"

namespace tremolo::materials::pm4 {

/// What plastic modulus and dilatancy share: products of the state with the direction of loading.
struct Direction {
  Deviator n;              ///< unit tensor
  double alpha_n = 0.0;    ///< alpha:n
  double z_n = 0.0;        ///< z:n
  double alpha_in_n = 0.0; ///< alpha_in:n, apparent
  double C_zpk2 = 0.0;     ///< z_peak/(z_cum + z_max/100), below 1
};

inline Direction direction(const Site& at, Deviator n) {
  const double C_zpk2 = at.now.z_peak / (at.now.z_cum + 0.01 * at.start.z_max);
  return {n, contract(at.now.alpha, n), contract(at.now.z, n), contract(at.memory->alpha_in.deviator(), n),
          std::min(C_zpk2, 1.0 - 1e-12)};
}

struct Dilatancy {
  double D = 0.0;
  bool contracts = false;
};

/// C_zin1
inline double fabric_since_reversal(const Site& at, const Direction& to) {
  const double change = std::abs(contract(at.memory->z_in, to.n) - to.z_n);
  return change == 0.0 ? 0.0 : 1.0 - elementary::exp(-2.0 * change / at.start.z_max);
}

/// The rotated dilatancy surface.
struct RotatedSurface {
  double a_z = 0.0;
  double C_zin1 = 0.0;
  double alpha_n = 0.0; ///< alpha_dR:n
};

inline double dilation(const Site& at, const Direction& to, const RotatedSurface& rotated) {
  const Initial& start = at.start;
  const Motion& now = at.now;
  const double ratio = 2.5 * at.p / at.memory->p_zp;
  const double ratio2 = ratio * ratio;
  const double C_pzp = 1.0 / (1.0 + ratio2 * ratio2 * ratio);
  const double small = 10.0 * start.p_min / at.p;
  const double C_pmin = 1.0 / (1.0 + small * small);
  const double u = (now.z_cum - now.z_peak) / (3.0 * start.z_max);
  const double C_zin2 = (1.0 + rotated.C_zin1 * u) / (1.0 + 3.0 * rotated.C_zin1 * u);
  const double unaligned = 1.0 - std::max(-to.z_n, 0.0) / (sqrt2 * now.z_peak);
  const double strain = now.z_cum * now.z_cum / start.z_max * unaligned * unaligned * unaligned;
  const double slower = at.law.c_eps * at.law.c_eps * C_pzp * C_pmin * rotated.C_zin1;
  const double A_d = start.A_do * C_zin2 / (1.0 + strain * slower);

  const double D_nr = A_d * ((at.surface.M_d - at.law.m) / sqrt2 - to.alpha_n);
  const double D_rot = A_d * rotated.a_z * (rotated.alpha_n - to.alpha_n) / at.law.C_DR;
  double D = D_nr;
  if (D_nr > D_rot) {
    const double below = std::max(at.surface.M_b - std::sqrt(at.M_cur2), 0.0);
    D += (D_rot - D_nr) * below / (below + 0.01);
  }
  if (at.p <= 2.0 * start.p_min) {
    const double forced = 3.5 * start.A_do * std::max(at.surface.M_b - at.surface.M_d, 0.0);
    D = std::min(D, -forced * (2.0 * start.p_min - at.p) / start.p_min);
  }
  return D;
}

/// C_pmin2, from 0 at 2 p_min to 1 at 18 p_min
inline double fading(double p, double p_min) {
  return p >= 18.0 * p_min ? 1.0 : std::max((p - 2.0 * p_min) / (16.0 * p_min), 0.0);
}

inline double contraction(const Site& at, const Direction& to) {
  const double C_pmin2 = fading(at.p, at.start.p_min);
  if (C_pmin2 == 0.0)
    return 0.0;
  const double dense = std::max(0.5 - at.surface.xi_R, 0.0);
  const double h_p = at.law.h_po * elementary::exp(-0.7 + 7.0 * dense * dense);
  const double C_rot2 = 1.0 - to.C_zpk2;
  const double z_max = at.start.z_max;
  const double C_dz = std::max((z_max - C_rot2 * sqrt2 * at.now.z_peak) / (z_max + C_rot2 * at.now.z_cum),
                               1.0 / (1.0 + 0.5 * z_max));
  const double aligned = std::max(to.z_n, 0.0);
  const double C_in = sqrt2 * aligned / z_max;
  const double X = (at.surface.M_d - at.law.m) / sqrt2 - to.alpha_n;
  const double travelled = to.alpha_n - to.alpha_in_n + C_in;
  const double A_do = at.start.A_do;
  const double rate = std::min(A_do * (1.0 + aligned) / (h_p * C_dz) * travelled * travelled, 1.5 * A_do);
  return C_pmin2 * rate * X / (X + 0.16);
}

inline Dilatancy dilatancy(const Site& at, const Direction& to) {
  RotatedSurface rotated;
  double M_dR = at.surface.M_d;
  if (to.z_n < 0.0) {
    rotated.a_z = -to.z_n / (sqrt2 * at.start.z_max);
    rotated.C_zin1 = fabric_since_reversal(at, to);
    M_dR /= 1.0 + 2.0 * rotated.a_z * (1.0 - rotated.C_zin1);
  }
  rotated.alpha_n = (M_dR - at.law.m) / sqrt2;
  if (rotated.alpha_n > to.alpha_n)
    return {contraction(at, to), true};
  if (to.z_n >= 0.0)
    rotated.C_zin1 = fabric_since_reversal(at, to);
  return {dilation(at, to, rotated), false};
}

} // namespace tremolo::materials::pm4
