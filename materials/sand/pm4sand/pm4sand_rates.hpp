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
struct Strain {
  double volumetric = 0.0;
  Deviator e; ///< in-plane deviator, with the tensor's shear component
};

inline Strain operator*(double factor, const Strain& strain) {
  return {factor * strain.volumetric, factor * strain.e};
}

/// What a (sub-)step changes.
struct Change {
  Stress stress;
  Deviator alpha;
  Deviator z;
  double plastic_work = 0.0; ///< L (s:n + p D), J/m3
};

inline Change elastic_change(const Site& here, const Strain& strain) {
  return {{(here.K + here.G / 3.0) * strain.volumetric, (2.0 * here.G) * strain.e}, {}, {}, 0.0};
}

/// The denominator of L. Where dilatancy would turn the elastic part of it negative, or softening the whole,
/// the soil keeps a rest of stiffness instead of running away.
inline double denominator(double K_p, double G, double coupling) {
  const double elastic = std::max(2.0 * G - coupling, 0.2 * G);
  return std::max(K_p + elastic, 0.5 * elastic);
}

/// The change under a strain increment if loading goes on in direction n (a unit tensor); elastic if L < 0.
inline Change change(const Site& here, Deviator n, const Strain& strain) {
  Change step = elastic_change(here, strain);
  const double n_r = contract(n, here.stress.s) / here.stress.p;
  const double driving = 2.0 * here.G * contract(n, strain.e) - n_r * here.K * strain.volumetric;
  if (driving <= 0.0)
    return step;
  const Motion& now = here.now;
  const double z_max = here.start.z_max;
  const Direction to = direction(here, n);
  const Dilatancy flow = dilatancy(here, to);
  const PlasticModulus plastic = plastic_modulus(here, to);
  const double K_p = flow.contracts ? std::max(plastic.K_p, 0.0) : plastic.K_p;
  const double L = driving / denominator(K_p, here.G, here.K * flow.D * n_r);

  step.stress.p -= L * here.K * flow.D;
  step.stress.s = step.stress.s - (2.0 * here.G * L) * n;
  step.alpha =
      std::min(2.0 / 3.0 * L * plastic.h, 1.0) * (((here.surface.M_b - here.law.m) / sqrt2) * n - now.alpha);
  if (flow.D < 0.0 && (here.surface.M_d - here.law.m) / sqrt2 < to.alpha_n) {
    const double slower = std::max(0.5 * now.z_cum / z_max, 1.0);
    step.z = (-here.law.c_z / slower * L) * (z_max * n + now.z);
  }
  step.plastic_work = L * here.stress.p * (n_r + flow.D);
  return step;
}

} // namespace tremolo::materials::pm4
