#pragma once

namespace tremolo::freefield {

/// Energy balance of a two-phase column since the start, J per m2 of plan area. Every entry is measured:
/// stresses and pressure by their work on the strain of their elements, tractions and drag by their work on
/// the nodes. Balance:
///
///     base + load + gravity = kinetic + elastic + plastic + pore + drag + damping,
///
/// and what is missing is the error of the integration in time, of second order in the step, and what water
/// carries along as it flows, in proportion to strain.
struct WetEnergy {
  /// work of the base on the column, of pressure that drives water in there, and of what moves the dashpots
  /// of mass-proportional damping with v_ref (base_motion.hpp)
  double base = 0.0;
  double load = 0.0;    ///< work of the load on the surface
  double gravity = 0.0; ///< work of the weight, under water the buoyant one, on soil that settles
  double kinetic = 0.0; ///< of grains and water
  double elastic = 0.0; ///< work of effective stress that the law does not count as plastic
  double plastic = 0.0; ///< dissipated by the law
  double pore = 0.0;    ///< work of pore pressure on the water, by which it is compressed
  double drag = 0.0;    ///< dissipated by water that flows through the grains
  double damping = 0.0; ///< dissipated by the soil's small-strain damping

  double given() const { return base + load + gravity; }
  double missing() const { return given() - kinetic - elastic - plastic - pore - drag - damping; }
};

} // namespace tremolo::freefield
