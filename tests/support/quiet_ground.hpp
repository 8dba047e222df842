#pragma once

// Eq. (6) where nothing arrives from outside: dashpots, matched layers and static tractions alone.

#include "mpm_domain/step/stepper.hpp"

#include <algorithm>
#include <span>

namespace tremolo::test_support {

/// A free field at rest.
inline mpm_domain::FreeFieldSource quiet_ground() {
  return [](long, double, std::span<const Vector>, std::span<eq6::FreeField> field) {
    std::ranges::fill(field, eq6::FreeField{});
  };
}

} // namespace tremolo::test_support
