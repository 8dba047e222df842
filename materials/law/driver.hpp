#pragma once

// A law driven at a single point. Each component of a step is controlled by strain or by stress; the strain
// increments behind prescribed stresses are found by Newton's method (mixed_control.hpp). Where it fails, the
// step is cut in halves, so that the law is followed from state to state.

#include "materials/law/law.hpp"
#include "materials/law/mixed_control.hpp"

#include <cstddef>
#include <string>
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
  double zz = 0.0; ///< out of plane; other than zero only for laws with the trait three_dimensional
};

/// Prescribed quantity of one component in a step: the strain increment, or the stress at the end of the step
/// (Pa).
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
  Control zz = Control::strain(0.0); ///< out of plane: other than plane strain only for laws that take it
  /// Stiffness K_w/n of pore water, Pa: prescribed normal stresses are then those of soil and of the water
  /// that this step compresses, sigma' + K_w/n tr(d_eps).
  double pore_stiffness = 0.0;
};

/// A material point at one instant.
struct PointState {
  PointStress stress;
  PointStrain strain;
  std::vector<double> variables; ///< the state block, in the order of state_variables(law)
  double plastic_work = 0.0;     ///< since the start per unit volume, J/m3
};

/// Tolerance on prescribed stresses.
struct StressTolerance {
  double wanted = 1e-6; ///< Pa, or 1e-13 of the largest stress if that is more
  /// Tolerance accepted if the law allows no better, as a fraction of the largest stress: laws that divide a
  /// step into sub-steps jump with their number. The error does not accumulate.
  double accepted = 1e-5;
  /// If no strain gives the prescribed stress, the nearest state is taken as long as at most this fraction of
  /// the largest stress is missing; 0: such a step is refused. See largest_missing().
  double nearest = 0.0;
};

/// Jumps to another branch of a law that gives a prescribed stress at several strains, or at none near the
/// expected one (mixed_control.hpp).
struct Leaps {
  std::size_t count = 0;
  PointStrain first;          ///< strain after the first of them
  double largest = 0.0;       ///< strain from where the controlled component was expected, of one leap
  std::size_t steps_away = 0; ///< steps on other branches until the first was come back to
};

/// A material point and its law.
class PointTest {
public:
  /// Starts from a given stress with the law's initial state and zero strain.
  /// @throws std::invalid_argument for parameters or stresses that are not physical
  PointTest(const Law& law, const PointStress& initial, const StressTolerance& tolerance = {});

  /// Takes one step. The point is unchanged if the step fails.
  /// @throws std::runtime_error if no strain gives the prescribed stresses, e.g. beyond a peak load
  /// @throws std::domain_error for a strain increment that the law cannot follow
  /// @throws std::invalid_argument for out-of-plane strain of a law that does not take it
  void apply(const PointStep& step);

  const PointStress& stress() const { return now_.stress; }
  const PointStrain& strain() const { return now_.strain; }
  /// The state block, in the order of state_variables(law).
  const std::vector<double>& state() const { return now_.variables; }
  /// Plastic work since the start per unit volume, J/m3
  double plastic_work() const { return now_.plastic_work; }
  const Law& law() const { return law_; }

  /// All of the point, to come back to.
  const PointState& now() const { return now_; }
  void set(const PointState& state) { now_ = state; }
  /// Updates of the law so far, trials included.
  std::size_t updates() const { return updates_; }
  /// Largest prescribed stress that was missing after a step taken as near as could be, Pa
  double largest_missing() const { return largest_missing_; }
  const Leaps& leaps() const { return leaps_; }

private:
  /// Updates a point by a strain increment and a rotation.
  void advance(PointState& point, const Components& strain, double rotation);
  /// Takes the mixed step if its stresses can be met, to a fraction of the largest stress.
  bool solve(const MixedStep& step, double rotation, double tolerance);
  void count_leap(const MixedControl::Found& found);
  /// Takes the step as near to its stresses as the tolerance allows.
  bool take_nearest(const MixedStep& step, double rotation);
  /// The step as two halves, each cut further where needed.
  void solve_in_halves(const MixedStep& step, double rotation, int depth);

  Law law_;
  PointState now_;
  PointState trial_;
  StressTolerance tolerance_;
  MixedControl control_;
  double largest_missing_ = 0.0;
  Leaps leaps_;
  double missing_ = 0.0; ///< of a prescribed stress after the last attempt, Pa
  std::string refusal_;  ///< what the law said when it refused a trial
  std::size_t updates_ = 0;
  bool three_dimensional_ = false;
};

} // namespace tremolo::materials
