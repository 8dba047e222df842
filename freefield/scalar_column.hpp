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
  /// Elements from the base to the surface; `base_impedance` is rho c of the half-space, Pa s/m.
  /// @throws std::invalid_argument for central differences with a step not below their stability limit
  ScalarColumn(std::vector<ScalarElement> elements, double base_impedance, double time_step,
               Integrator integrator);

  /// Advances one step; `incident_velocity` (m/s) is that of the upgoing wave at the base at the step's end.
  /// @throws std::runtime_error if the motion is no longer finite
  void step(double incident_velocity);

  /// The element's state at a fraction in [0, 1] of its length from its lower node.
  ScalarSample sample(std::size_t element, double fraction) const;

  ColumnEnergy energy() const;

private:
  using Vector = std::vector<double>; ///< one value a node, from the base up

  void step_central_difference(double incident_velocity);
  void step_newmark(double incident_velocity);
  void factor_newmark();
  void solve_newmark(Vector& right_hand_side) const;
  /// K u + beta K v, with which the elements resist at the nodes, Pa.
  Vector internal_forces(const Vector& u, const Vector& v) const;
  double base_traction() const { return impedance_ * (2.0 * incident_ - v_[0]); }
  void account(const Vector& v_before, double base_traction_before);

  std::vector<ScalarElement> elements_;
  double impedance_;
  double dt_;
  Integrator integrator_;
  Vector mass_;                           ///< kg/m2
  Vector dashpots_;                       ///< mass-proportional damping, and the base's impedance, Pa s/m
  Vector factor_below_, factor_diagonal_; ///< L D L^T of the Newmark matrix: L's subdiagonal, D
  Vector u_, v_, a_;                      ///< m, m/s, m/s2
  Vector jerk_;                           ///< backward difference of a_, m/s3
  Vector stress_velocity_; ///< that the damping stress of the elements takes: v_, or its extrapolation, m/s
  double incident_ = 0.0;  ///< m/s
  ColumnEnergy spent_;     ///< work and dissipation so far
};

/// The largest stable step of central differences, s (derived in scalar_column.cpp).
double central_difference_limit(const std::vector<ScalarElement>& elements);

} // namespace tremolo::freefield
