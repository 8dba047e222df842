#pragma once

#include <string>
#include <string_view>

namespace tremolo::freefield {

/// @throws std::invalid_argument "`what` is `value`, must be `allowed`" unless `condition` holds. Conditions
/// are
///         written so that NaN fails them.
void require(bool condition, std::string_view what, double value, std::string_view allowed);

/// A number as short as messages want it, 6 significant digits.
std::string shortest(double value);

} // namespace tremolo::freefield
