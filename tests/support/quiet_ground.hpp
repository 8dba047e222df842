#pragma once

// Eq. (6) where nothing arrives from outside: dashpots and static tractions alone.

#include "mpm_domain/step/stepper.hpp"

#include <span>
#include <vector>

namespace tremolo::test_support {

/// @param domain outlives what is returned
inline mpm_domain::TractionSource quiet_ground(const mpm_domain::Domain& domain) {
  return
      [&domain](long, double, std::span<const mpm_domain::Vector> v, std::span<mpm_domain::Vector> traction) {
        for (std::size_t f = 0; f < v.size(); ++f)
          traction[f] = eq6::boundary_traction(domain.faces[f].face, v[f], {}, domain.static_tractions[f]);
      };
}

/// Steps a domain before such ground from t = 0 on; matched layers are told that the free field rests.
inline mpm_domain::Stepper quiet_stepper(mpm_domain::Domain& domain) {
  return {domain, 0.0, quiet_ground(domain), [rest = std::vector<eq6::FreeField>(domain.faces.size())] {
            return std::span<const eq6::FreeField>(rest);
          }};
}

} // namespace tremolo::test_support
