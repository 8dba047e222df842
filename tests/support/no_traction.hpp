#pragma once

#include "mpm_domain/step/stepper.hpp"

#include <algorithm>

namespace tremolo::test_support {

/// Boundaries that nothing pulls at.
inline mpm_domain::TractionSource no_traction() {
  return [](long, double, auto, auto traction) { std::ranges::fill(traction, mpm_domain::Vector{}); };
}

} // namespace tremolo::test_support
