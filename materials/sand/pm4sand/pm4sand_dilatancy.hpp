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
// Four points at a time: where they do not all do the same, all of it is computed and each takes its own.
// Near zero effective stress contraction fades (2 to 18 p_min) and dilation is forced (below 2 p_min).

#include "materials/sand/pm4sand/pm4sand_four.hpp"
#include "materials/sand/pm4sand/pm4sand_surfaces.hpp"

namespace tremolo::materials::pm4 {

using Sites = SiteOf<Lanes>;

/// Quantities shared by plastic modulus and dilatancy: products of the state with the direction of loading.
struct Directions {
  Deviators n;      ///< unit tensor
  Lanes alpha_n;    ///< alpha:n
  Lanes z_n;        ///< z:n
  Lanes alpha_in_n; ///< alpha_in:n, apparent
  Lanes C_zpk2;     ///< z_peak/(z_cum + z_max/100), below 1
};

inline Directions directions(const Sites& at, const Deviators& n) {
  const Lanes C_zpk2 = at.now.z_peak / (at.now.z_cum + 0.01 * at.start.z_max);
  return {n, contract(at.now.alpha, n), contract(at.now.z, n), contract(at.memory->alpha_in.deviator(), n),
          smaller(all(1.0 - 1e-12), C_zpk2)};
}

struct Dilatancy {
  Lanes D;
  LaneMask contracts;
};

/// C_zin1
inline Lanes fabric_since_reversal(const Sites& at, const Directions& to) {
  const Lanes change = magnitude(contract(at.memory->z_in, to.n) - to.z_n);
  return choose(change == 0.0, Lanes{}, 1.0 - elementary::exp(-2.0 * change / at.start.z_max));
}

/// The rotated dilatancy surface.
struct RotatedSurface {
  Lanes a_z;
  Lanes C_zin1;
  Lanes alpha_n; ///< alpha_dR:n
};

inline Lanes dilation(const Sites& at, const Directions& to, const RotatedSurface& rotated) {
  const Initials& start = at.start;
  const Motions& now = at.now;
  const Lanes ratio = 2.5 * at.p / at.memory->p_zp;
  const Lanes ratio2 = ratio * ratio;
  const Lanes C_pzp = 1.0 / (1.0 + ratio2 * ratio2 * ratio);
  const Lanes small = 10.0 * start.p_min / at.p;
  const Lanes C_pmin = 1.0 / (1.0 + small * small);
  const Lanes u = (now.z_cum - now.z_peak) / (3.0 * start.z_max);
  const Lanes C_zin2 = (1.0 + rotated.C_zin1 * u) / (1.0 + 3.0 * rotated.C_zin1 * u);
  const Lanes unaligned = 1.0 - positive(-to.z_n) / (sqrt2 * now.z_peak);
  const Lanes strain = now.z_cum * now.z_cum / start.z_max * unaligned * unaligned * unaligned;
  const Lanes slower = at.law.c_eps * at.law.c_eps * C_pzp * C_pmin * rotated.C_zin1;
  const Lanes A_d = start.A_do * C_zin2 / (1.0 + strain * slower);

  const Lanes D_nr = A_d * ((at.surface.M_d - at.law.m) / sqrt2 - to.alpha_n);
  const Lanes D_rot = A_d * rotated.a_z * (rotated.alpha_n - to.alpha_n) / at.law.C_DR;
  const Lanes below = positive(at.surface.M_b - sqrt(at.M_cur2));
  const Lanes D = choose(D_nr > D_rot, D_nr + (D_rot - D_nr) * below / (below + 0.01), D_nr);
  const Lanes forced = 3.5 * start.A_do * positive(at.surface.M_b - at.surface.M_d);
  return choose(at.p <= 2.0 * start.p_min, smaller(-forced * (2.0 * start.p_min - at.p) / start.p_min, D), D);
}

/// C_pmin2, from 0 at 2 p_min to 1 at 18 p_min
inline Lanes fading(const Lanes& p, const Lanes& p_min) {
  return choose(p >= 18.0 * p_min, all(1.0), positive((p - 2.0 * p_min) / (16.0 * p_min)));
}

inline Lanes contraction(const Sites& at, const Directions& to) {
  const Lanes C_pmin2 = fading(at.p, at.start.p_min);
  const Lanes dense = positive(0.5 - at.surface.xi_R);
  const Lanes h_p = at.law.h_po * elementary::exp(-0.7 + 7.0 * dense * dense);
  const Lanes C_rot2 = 1.0 - to.C_zpk2;
  const Lanes z_max = at.start.z_max;
  const Lanes C_dz = larger(1.0 / (1.0 + 0.5 * z_max),
                            (z_max - C_rot2 * sqrt2 * at.now.z_peak) / (z_max + C_rot2 * at.now.z_cum));
  const Lanes aligned = positive(to.z_n);
  const Lanes C_in = sqrt2 * aligned / z_max;
  const Lanes X = (at.surface.M_d - at.law.m) / sqrt2 - to.alpha_n;
  const Lanes travelled = to.alpha_n - to.alpha_in_n + C_in;
  const Lanes A_do = at.start.A_do;
  const Lanes rate = smaller(1.5 * A_do, A_do * (1.0 + aligned) / (h_p * C_dz) * travelled * travelled);
  return choose(C_pmin2 == 0.0, Lanes{}, C_pmin2 * rate * X / (X + 0.16));
}

inline Dilatancy dilatancy(const Sites& at, const Directions& to) {
  const LaneMask turned = to.z_n < 0.0;
  RotatedSurface rotated{};
  Lanes M_dR = at.surface.M_d;
  if (any(turned)) {
    rotated.a_z = choose(turned, -to.z_n / (sqrt2 * at.start.z_max), Lanes{});
    rotated.C_zin1 = fabric_since_reversal(at, to);
    M_dR = choose(turned, M_dR / (1.0 + 2.0 * rotated.a_z * (1.0 - rotated.C_zin1)), M_dR);
  }
  rotated.alpha_n = (M_dR - at.law.m) / sqrt2;
  const LaneMask contracts = rotated.alpha_n > to.alpha_n;
  Lanes D{};
  if (any(contracts))
    D = contraction(at, to);
  if (any(~contracts)) {
    rotated.C_zin1 = fabric_since_reversal(at, to);
    D = choose(contracts, D, dilation(at, to, rotated));
  }
  return {D, contracts};
}

} // namespace tremolo::materials::pm4
