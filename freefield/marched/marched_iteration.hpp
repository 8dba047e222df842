#pragma once

#include "freefield/marched/marched_tangent.hpp"
#include "freefield/marched/marched_trial.hpp"

#include <cstddef>

namespace tremolo::freefield {

/// Finds the increments of stress of each step, and counts what that takes.
class MarchedIteration {
public:
  /// @param tolerance  of the laws' last residual, relative to the largest increment so far
  /// @param rounding   of the stress, Pa, which is tolerated beside it
  MarchedIteration(std::size_t elements, double tolerance, double rounding);

  /// Brings a trial that has begun to where it can be accepted.
  void converge(MarchedTrial& trial, const MarchedScheme& scheme, const MarchedState& state,
                MarchedTangent& tangent);

  long evaluations() const { return evaluations_; } ///< calls of the laws
  /// Steps whose increments did not converge, and the largest residual that such a step was left with,
  /// relative to the largest increment so far.
  long unconverged() const { return unconverged_; }
  double largest_residual() const { return largest_residual_; }

private:
  void guess(MarchedTrial& trial, const MarchedScheme& scheme, MarchedTangent& tangent);
  double evaluate(MarchedTrial& trial, const MarchedScheme& scheme, const MarchedState& state);
  bool tolerated(double residual) const;

  double tolerance_, rounding_;
  Increments increment_, residual_, correction_, uncorrected_;
  Increments shortfall_, shortfall_before_; ///< Z of the last two steps, Pa
  double largest_increment_ = 0.0;          ///< of stress in a step so far, Pa
  double largest_residual_ = 0.0;
  long evaluations_ = 0, unconverged_ = 0;
};

} // namespace tremolo::freefield
