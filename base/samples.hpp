#pragma once

// Functions for the samples of any history.

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo {

/// Largest absolute value.
inline double peak(std::span<const double> samples) {
  double largest = 0.0;
  for (const double value : samples)
    largest = std::max(largest, std::abs(value));
  return largest;
}

/// @throws std::invalid_argument unless a history called `what` has samples and all of them are finite
inline void require_finite_samples(std::string_view what, std::span<const double> samples) {
  if (samples.empty())
    throw std::invalid_argument("a " + std::string(what) + " without samples");
  for (const double value : samples)
    require(std::isfinite(value), "a sample of the " + std::string(what), value, "finite");
}

} // namespace tremolo
