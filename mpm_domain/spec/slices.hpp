#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>

namespace tremolo::mpm_domain {

/// Index of the soil at a level of a region in which soils lie one below the other in slices.
/// @param first  index of the uppermost soil; the others follow it
/// @param cuts   y at which the next soil begins, from the top down, m
/// @param y      m
inline std::size_t soil_at(std::size_t first, std::span<const double> cuts, double y) {
  return first + static_cast<std::size_t>(std::ranges::upper_bound(cuts, y, std::greater{}) - cuts.begin());
}

} // namespace tremolo::mpm_domain
