#pragma once

// A law driven at a single point. Each in-plane component of a step is controlled by strain or by stress; the
// strain increments behind prescribed stresses are found by Newton's method with a finite-difference tangent.

#include "materials/law.hpp"

#include <vector>

namespace tremolo::materials {

/// Stress of a point in plane strain, Pa, tension positive.
struct PointStress {
  double xx = 0.0;
  double yy = 0.0;
  double zz = 0.0;
  double xy = 0.0;
};

/// Strain of a point since the start of its test; xy is the engineering shear strain.
struct PointStrain {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
};

/// What a step prescribes of one component: the strain increment, or the stress at the end of the step (Pa).
class Control {
public:
  static Control strain(double increment) { return {false, increment}; }
  static Control stress(double target) { return {true, target}; }
  bool by_stress() const { return by_stress_; }
  double value() const { return value_; }

private:
  Control(bool by_stress, double value) : by_stress_(by_stress), value_(value) {}
  bool by_stress_;
  double value_;
};

/// One step of a single-point test.
struct PointStep {
  Control xx = Control::strain(0.0);
  Control yy = Control::strain(0.0);
  Control xy = Control::strain(0.0); ///< engineering shear strain, or sigma_xy
  double rotation = 0.0;             ///< rotation increment, rad, counter-clockwise positive
};

/// A material point and its law.
class PointTest {
public:
  /// Starts from a given stress with the law's initial state and zero strain.
  /// @throws std::invalid_argument for parameters or stresses that are not physical
  PointTest(const Law& law, const PointStress& initial);

  /// Takes one step.
  /// @throws std::runtime_error if no strain gives the prescribed stresses, e.g. beyond a peak load
  void apply(const PointStep& step);

  const PointStress& stress() const { return stress_; }
  const PointStrain& strain() const { return strain_; }
  /// The state block, in the order of state_variables(law).
  const std::vector<double>& state() const { return state_; }
  /// Plastic work since the start per unit volume, J/m3
  double plastic_work() const { return plastic_work_; }
  const Law& law() const { return law_; }

private:
  /// This point's arrays; the increments must outlive the view.
  Points view(const PointStrain& increment, const double& rotation);
  /// The point after a trial strain increment; this point stays as it is.
  PointTest after(const PointStrain& increment, double rotation) const;

  Law law_;
  PointStress stress_;
  PointStrain strain_;
  std::vector<double> state_;
  double plastic_work_ = 0.0;
};

} // namespace tremolo::materials
