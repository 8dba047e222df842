#pragma once

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

enum class Integrator {
  central_difference, ///< explicit; refuses a step over the stability limit
  newmark             ///< average acceleration (1/4, 1/2): implicit, unconditionally stable, factored once
};

/// Energies of a column since the start, J per m2 of plan area. Balance: base_work = kinetic + strain +
/// damping.
struct ColumnEnergy {
  double kinetic = 0.0;
  double strain = 0.0;
  double damping = 0.0;   ///< dissipated in the soil
  double base_work = 0.0; ///< work of the traction on the base
};

/// One element of a column of scalar waves.
struct ScalarElement {
  double length = 0.0;  ///< m
  double density = 0.0; ///< kg/m3
  double modulus = 0.0; ///< Pa: G for shear, M for dilation
  double alpha = 0.0;   ///< mass-proportional damping, 1/s
  double beta = 0.0;    ///< stiffness-proportional damping, s
};

/// The state of a column at one level.
struct ScalarSample {
  double velocity = 0.0;      ///< m/s
  double acceleration = 0.0;  ///< m/s2
  double traction = 0.0;      ///< Pa, on a face with normal +y
  double traction_rate = 0.0; ///< Pa/s
};

/// One polarisation of a free-field column in linear elements with lumped mass, free at the top, on a dashpot
/// at the base that carries the incident wave. Starts at rest.
class ScalarColumn {
public:
  /// Elements from the base to the surface. `base_impedance` is rho c of the half-space, Pa s/m.
  ScalarColumn(std::vector<ScalarElement> elements, double base_impedance, double time_step,
               Integrator integrator);

  /// Advances one step; `incident_velocity` (m/s) is that of the upgoing wave at the base at the step's end.
  void step(double incident_velocity);

  /// Element `element` at the fraction xi in [0, 1] of its length from its lower node.
  ScalarSample sample(std::size_t element, double xi) const;

  const ColumnEnergy& energy() const { return energy_; }
  bool is_finite() const;

private:
  void step_central_difference(double incident_velocity);
  void step_newmark(double incident_velocity);
  void factor_newmark();
  void add_internal_force(std::vector<double>& force, double sign) const;

  std::vector<ScalarElement> elements_;
  double impedance_;
  double dt_;
  Integrator integrator_;
  std::vector<double> mass_, mass_damping_;
  std::vector<double> u_, v_, a_, jerk_;
  ColumnEnergy energy_;
};

/// The largest stable step of central differences, s (see scalar_column.cpp for its derivation).
double central_difference_limit(const std::vector<ScalarElement>& elements);

} // namespace tremolo::freefield
