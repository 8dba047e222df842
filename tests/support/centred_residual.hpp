#pragma once

#include "mpm_domain/passes/energy_ledger.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::test_support {

/// The residual of a ledger, J/m, with all entries at one time: after a step, kinetic energy is known half a
/// step before the rest, and the mean of two steps belongs to the time between them.
class CentredResidual {
public:
  void after_step(const mpm_domain::EnergyLedger& energy) {
    const double strain = energy.elastic + energy.viscous;
    const double rest = energy.residual() - energy.kinetic - strain;
    if (steps_ > 0)
      largest_ = std::max(largest_, std::abs(0.5 * (energy.kinetic + kinetic_ + rest + rest_) + strain_));
    kinetic_ = energy.kinetic;
    strain_ = strain;
    rest_ = rest;
    ++steps_;
  }

  /// Of any time so far.
  double largest() const { return largest_; }

private:
  long steps_ = 0;
  double kinetic_ = 0.0;
  double strain_ = 0.0; ///< elastic energy and viscous work
  double rest_ = 0.0;   ///< residual less these and kinetic energy
  double largest_ = 0.0;
};

} // namespace tremolo::test_support
