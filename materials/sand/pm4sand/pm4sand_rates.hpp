#pragma once

// Rates of PM4Sand (Boulanger & Ziotopoulou 2017, section 2.3; Dafalias & Manzari 2004). With the loading
// index L, in the plane and compression positive,
//
//     L = [2G n:d_eps - (n:r) K d_epsv]/H,    H = K_p + 2G - K D (n:r),
//     d_sigma = 2G d_e + K d_epsv I - L (2G n + K D I),    d_e = d_eps - d_epsv/3 I,
//     d_alpha = 2/3 L h (alpha_b - alpha),
//     d_z = -c_z/(1 + <z_cum/(2 z_max) - 1>) L (z_max n + z)    while beyond M_d and dilating,
//
// alpha at most as far as the bounding surface, and L < 0 is unloading. In the plane d_p = (K + G/3) d_epsv -
// L K D.

#include "materials/sand/pm4sand/pm4sand_plastic_modulus.hpp"

namespace tremolo::materials::pm4 {

/// Strain increment, compression positive.
struct Strains {
  Lanes volumetric;
  Deviators e; ///< in-plane deviator, with the tensor's shear component
};

inline Strains operator*(const Lanes& factor, const Strains& strain) {
  return {factor * strain.volumetric, factor * strain.e};
}

/// Changes in a (sub-)step.
struct Changes {
  Stresses stress;
  Deviators alpha;
  Deviators z;
  Lanes plastic_work; ///< L (s:n + p D), J/m3
};

inline Changes elastic_change(const Sites& here, const Strains& strain) {
  return {{(here.K + here.G / 3.0) * strain.volumetric, (2.0 * here.G) * strain.e}, {}, {}, Lanes{}};
}

/// The denominator of L. Where dilatancy would turn the elastic part of it negative, or softening the whole,
/// the soil keeps a rest of stiffness instead of running away.
inline Lanes denominator(const Lanes& K_p, const Lanes& G, const Lanes& coupling) {
  const Lanes elastic = larger(0.2 * G, 2.0 * G - coupling);
  return larger(0.5 * elastic, K_p + elastic);
}

/// The change under a strain increment if loading goes on in direction n, a unit tensor, or 0 where the soil
/// is elastic; elastic if L < 0.
inline Changes change(const Sites& here, const Deviators& n, const Strains& strain) {
  const Changes elastic = elastic_change(here, strain);
  const Lanes n_r = contract(n, here.stress.s) / here.stress.p;
  const Lanes driving = 2.0 * here.G * contract(n, strain.e) - n_r * here.K * strain.volumetric;
  const LaneMask loads = ~(driving <= 0.0);
  if (!any(loads))
    return elastic;
  const Motions& now = here.now;
  const Lanes z_max = here.start.z_max;
  const Directions to = directions(here, n);
  const Dilatancy flow = dilatancy(here, to);
  const PlasticModulus plastic = plastic_modulus(here, to);
  const Lanes K_p = choose(flow.contracts, larger(Lanes{}, plastic.K_p), plastic.K_p);
  const Lanes L = driving / denominator(K_p, here.G, here.K * flow.D * n_r);

  const Lanes towards = smaller(all(1.0), 2.0 / 3.0 * L * plastic.h);
  const Deviators alpha = towards * (((here.surface.M_b - here.law.m) / sqrt2) * n - now.alpha);
  const LaneMask dilates = loads & (flow.D < 0.0) & ((here.surface.M_d - here.law.m) / sqrt2 < to.alpha_n);
  Deviators z{};
  if (any(dilates)) {
    const Lanes slower = larger(all(1.0), 0.5 * now.z_cum / z_max);
    z = choose(dilates, (-here.law.c_z / slower * L) * (z_max * n + now.z), z);
  }
  return {choose(loads, {elastic.stress.p - L * here.K * flow.D, elastic.stress.s - (2.0 * here.G * L) * n},
                 elastic.stress),
          choose(loads, alpha, {}), z, choose(loads, L * here.stress.p * (n_r + flow.D), Lanes{})};
}

} // namespace tremolo::materials::pm4
