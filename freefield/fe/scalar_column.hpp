#pragma once

#include "freefield/base_motion.hpp"

#include <cstddef>
#include <vector>

namespace tremolo::freefield {

enum class Integrator {
  central_difference, ///< explicit; refuses a step over the stability limit
  newmark             ///< average acceleration (1/4, 1/2) or its form with numerical damping: implicit,
                      ///< unconditionally stable for linear soil
};

/// The parameters of Newmark's family after Hilber, Hughes and Taylor (1977), Earthq. Eng. Struct. Dyn. 5,
/// 283-292; alpha = 0 is average acceleration.
struct HhtParameters {
  double alpha = 0.0; ///< in [-1/3, 0]
  double beta = 0.25;
  double gamma = 0.5;

  static HhtParameters from_alpha(double alpha) {
    return {alpha, 0.25 * (1.0 - alpha) * (1.0 - alpha), 0.5 - alpha};
  }
};

/// Energies of a column since the start, J per m2 of plan area. Balance: base_work = kinetic + strain +
/// plastic + damping; with Hilber, Hughes and Taylor's alpha below 0 what is missing on the right is the
/// integrator's own dissipation.
struct ColumnEnergy {
  double kinetic = 0.0;
  double strain = 0.0;    ///< elastic
  double plastic = 0.0;   ///< taken by the soil's hysteresis, of which Masing loops give some back
  double damping = 0.0;   ///< dissipated by the soil's small-strain damping
  double base_work = 0.0; ///< work of the traction on the base, and of what moves the dashpots of
                          ///< mass-proportional damping with v_ref (base_motion.hpp)
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
  double displacement = 0.0;  ///< m
};

/// How a column of scalar waves is marched and held.
struct ScalarSettings {
  BaseKind base = BaseKind::compliant;
  double base_impedance = 0.0; ///< rho c of the half-space, Pa s/m; of a compliant base
  double time_step = 0.0;      ///< s
  Integrator integrator = Integrator::newmark;
  double hht_alpha = 0.0; ///< in [-1/3, 0]
};

/// One polarisation of a free-field column in linear elements with lumped mass, free at the top, at the base
/// on a dashpot that carries the incident wave or moved by the motion prescribed. Starts at rest.
class ScalarColumn {
public:
  /// Elements from the base to the surface.
  /// @throws std::invalid_argument for central differences with a step not below their stability limit
  ScalarColumn(std::vector<ScalarElement> elements, const ScalarSettings& settings);

  /// Advances one step; `base` is the input motion at the step's end.
  /// @throws std::runtime_error if the motion is no longer finite
  void step(const BaseComponent& base);

  /// The element's state at a fraction in [0, 1] of its length from its lower node.
  ScalarSample sample(std::size_t element, double fraction) const;

  /// Strain at an element's centre.
  double strain(std::size_t element) const;

  ColumnEnergy energy() const;

private:
  using Vector = std::vector<double>; ///< one value a node, from the base up

  void step_central_difference();
  void step_newmark();
  void factor_newmark();
  void solve_newmark(Vector& right_hand_side) const;
  /// K u + beta K v + c (v - v_ref) - f: what the soil, the dashpots and the half-space resist with, Pa.
  Vector resistance(const Vector& u, const Vector& v, const Vector& dashpot_velocity) const;
  double element_stress(std::size_t element, const Vector& u, const Vector& v) const;
  bool rigid() const { return settings_.base == BaseKind::rigid; }
  void hold_base();
  double base_traction() const { return settings_.base_impedance * (2.0 * base_.velocity - v_[0]); }
  void account(const Vector& u_before, const Vector& v_before, double resistance_before,
               double reference_before);

  std::vector<ScalarElement> elements_;
  ScalarSettings settings_;
  HhtParameters hht_;
  Vector mass_;                           ///< kg/m2
  Vector mass_damping_;                   ///< alpha times mass, Pa s/m
  Vector dashpots_;                       ///< mass-proportional damping, and the base's impedance, Pa s/m
  Vector factor_below_, factor_diagonal_; ///< L D L^T of the Newmark matrix: L's subdiagonal, D
  Vector u_, v_, a_;                      ///< m, m/s, m/s2
  Vector motion_acceleration_;            ///< of the equation of motion at the step's end, m/s2
  Vector jerk_;                           ///< backward difference of it, m/s3
  Vector resistance_;                     ///< at the step's end, Pa
  Vector stress_velocity_; ///< that the damping stress of the elements takes: v_, or its extrapolation, m/s
  BaseComponent base_;
  double reference_rate_ = 0.0; ///< of v_ref over the step, m/s2
  double base_traction_ = 0.0;  ///< of the half-space at the step's end, Pa
  ColumnEnergy spent_;          ///< work and dissipation so far
};

/// The largest stable step of central differences, s (derived in scalar_column.cpp).
double central_difference_limit(const std::vector<ScalarElement>& elements);

/// @throws std::invalid_argument stating the limit unless the step is below it
void require_stable(double time_step, double limit);

} // namespace tremolo::freefield
