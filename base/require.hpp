#pragma once

#include <string>
#include <string_view>

namespace tremolo {

/// A number as short as messages want it, 6 significant digits.
std::string shortest(double value);

/// @param condition written so that NaN fails it
/// @throws std::invalid_argument "`what` is `value`, must be `allowed`" unless the condition holds
void require(bool condition, std::string_view what, double value, std::string_view allowed);

/// @throws std::invalid_argument unless the value is positive and finite
void require_positive(std::string_view what, double value, std::string_view unit);

} // namespace tremolo
