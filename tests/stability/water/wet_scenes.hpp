#pragma once

// What hard cases of saturated ground measure.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/hard_case.hpp"
#include "tests/support/quiet_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace tremolo::test_support {

/// At rest under gravity.
inline std::unique_ptr<mpm_domain::Domain> at_rest(const mpm_domain::Spec& spec) {
  auto domain = std::make_unique<mpm_domain::Domain>(spec);
  mpm_domain::replace_constraints(*domain, mpm_domain::relax_under_gravity(*domain, {}, [](long, double) {}));
  return domain;
}

/// The largest of a number of every wet particle.
template <typename Of>
double largest_wet(const mpm_domain::Domain& domain, const Of& of) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const mpm_domain::Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
      largest = std::max(largest, of(set, k));
  return largest;
}

inline double excess_of(const mpm_domain::Particles& set, std::size_t k) {
  return mpm_domain::excess_pressure(set, k);
}

/// |n w|, m/s
inline double flux(const mpm_domain::Particles& set, std::size_t k) {
  return set.water->porosity(set.mass[k], set.volume[k]) *
         std::hypot(set.wx[k] - set.vx[k], set.wy[k] - set.vy[k]);
}

inline double speed(const mpm_domain::Particles& set, std::size_t k) {
  return std::hypot(set.vx[k], set.vy[k]);
}

/// The residual of the ledger over the largest energy in it.
inline double ledger_error(const mpm_domain::EnergyLedger& e) {
  return std::abs(e.residual()) /
         std::max({e.kinetic, std::abs(e.elastic), e.plastic, std::abs(e.gravity), e.drag, e.viscous});
}

} // namespace tremolo::test_support
