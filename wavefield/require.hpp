#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo::wavefield {

/// A number as short as messages want it, 6 significant digits.
std::string shortest(double value);

/// @throws std::invalid_argument "`what` is `value`, must be `allowed`" unless `condition` holds. Conditions
/// are
///         written so that NaN fails them.
void require(bool condition, std::string_view what, double value, const std::string& allowed);

inline void require_positive(std::string_view what, double value, const std::string& unit) {
  require(value > 0.0 && std::isfinite(value), what, value, "positive and finite, in " + unit);
}

} // namespace tremolo::wavefield
