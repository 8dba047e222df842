#pragma once

// The pore water of a set of wet particles. With rho_s the density of its grains and m_s the mass of the
// grains of a particle, which stays the same while its volume V changes, its porosity is
//
//     n = 1 - m_s/(rho_s V),        m_s/rho_s = c m,
//
// where m is the mass that moves with the particle: that of the grains where water flows, and that of grains
// and water where it does not.
//
// Pressure is kept as it would be if water bore any tension, p*. Water that cavitates bears p_cav, and p
// rises again only when the cavity has closed, for p* has gone on falling while the cavity grew:
//
//     p = max(p*, p_cav).
//
// Forces see the excess over the pressure of the undisturbed water at the particle's present position
// (rest_pressure.hpp),
//
//     p_e = p - gamma (h - y),      gamma = rho_f g,
//
// with its head h (head/head.hpp), and soil under water weighs less by the water that it displaces. Both are
// the momentum balance without its hydrostatic part, so that water at rest exerts no force at all, however
// particles lie in their cells. Where h varies, it leaves the seepage force -gamma grad h
// (water/seepage_force.hpp).

#include "materials/water/pore_water.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

struct PoreWater {
  materials::PoreSpace pores; ///< at the start
  materials::PoreFluid fluid;
  double level = 0.0;           ///< the head where it is the same everywhere: y of the table, m
  double unit_weight = 0.0;     ///< gamma, N/m3
  double grains_per_mass = 0.0; ///< c, m3/kg

  bool flows() const { return pores.drainage == materials::Drainage::coupled; }
  /// n of particles of mass m (kg/m) and volume V (m2)
  template <typename Real>
  Real porosity(const Real& mass, const Real& volume) const {
    return 1.0 - grains_per_mass * mass / volume;
  }
  /// p of p*, Pa
  double pressure(double unclipped) const { return std::max(unclipped, fluid.cavitation_pressure); }
  /// rho_f g/k, Pa s/m2
  double resistance() const { return unit_weight / pores.permeability; }
};

} // namespace tremolo::mpm_domain
