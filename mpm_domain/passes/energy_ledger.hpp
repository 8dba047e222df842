#pragma once

// The energy balance. Over a step of length dt, with v- and v+ the grid velocity before and after the update
// and v = (v- + v+)/2, the grid's kinetic energy changes exactly by dt times the power of all nodal forces on
// v:
//
//     K(v+) - K(v-) = dt sum_i f_i . v_i.
//
// Gravity, dashpots, the rest of the boundary tractions and the stresses each give a part of f. What the
// stresses take is not booked from f but from the particles, V (s- + s+)/2 : de, as elastic, plastic and
// viscous work; what the transfer between grid and particles loses is booked as K(v-) of the next step minus
// K(v+) of this one. All entries are thus measured, and
//
//     residual = kinetic - kinetic_0 + elastic + plastic + viscous + pore + drag + friction + impact +
//     springs - gravity - input - static - dashpots - transfer
//
// is a true check: it holds the error of the time integration alone.
//
// Below the water table, kinetic energy is that of grains and water, the excess pore pressure takes up the
// work `pore`, drag dissipates what the water loses on its way through the grains (water/mixture_update.hpp),
// and the weight is that under water.
//
// Springs beside dashpots (boundary/springs/ground_springs.hpp) take up `springs`, which they store; behind a
// lag part of it is dissipated. What the free field does at their far ends, f^spr . v^ff, is input.
//
// Structures have kinetic energy and weight as the soil has; sliding along them dissipates `friction`, and
// where soil and structures, or two structures, take a common velocity the impulses dissipate `impact`
// (contact/contact.hpp). Linings do likewise; what their elements store is elastic work, and what backward
// Euler damps of their motion is viscous (lining/lining_body.hpp).

#include "mpm_domain/spec/output_columns.hpp"

#include <array>
#include <vector>

namespace tremolo::mpm_domain {

/// Energies per metre out of plane, J/m, accumulated since the start of shaking; work done on the soil is
/// positive.
struct EnergyLedger {
  double kinetic_start = 0.0;
  double kinetic = 0.0;
  double elastic = 0.0;  ///< work stored in elastic strain
  double plastic = 0.0;  ///< work dissipated in plastic strain, >= 0
  double viscous = 0.0;  ///< work dissipated by viscous damping, >= 0
  double pore = 0.0;     ///< work taken up by the excess pressure of pore water
  double drag = 0.0;     ///< work dissipated between water and grains, >= 0
  double friction = 0.0; ///< work dissipated by sliding along structures, >= 0
  double impact = 0.0;   ///< work dissipated where structures and soil meet
  double springs = 0.0;  ///< work taken up by springs beside the dashpots
  double gravity = 0.0;
  double input = 0.0;    ///< work of free-field velocity and stress through the boundary faces
  double static_ = 0.0;  ///< work of the tractions that replaced the constraints, and of loads
  double dashpots = 0.0; ///< work of the dashpots on the soil's own velocity, <= 0, and of matched layers
  double transfer = 0.0; ///< gained (> 0) or lost (< 0) between particles and grid: numerical

  double residual() const {
    return kinetic - kinetic_start + elastic + plastic + viscous + pore + drag + friction + impact + springs -
           gravity - input - static_ - dashpots - transfer;
  }

  /// The values of one row of the energy history, by energy_columns.
  std::array<double, energy_columns.size()> row() const;

  /// All entries, for a checkpoint, and back.
  std::vector<double> state() const;
  void set_state(const std::vector<double>& state);
};

} // namespace tremolo::mpm_domain
