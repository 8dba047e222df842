#pragma once

#include <string>
#include <string_view>

namespace tremolo::coupler {

/// The process that evaluates Eq. (6); the tractions agree to the last bit.
enum class Mode {
  lockstep, ///< in the hub: velocities out, tractions back, each step
  window    ///< in the domain: sources run ahead, velocities flow back in batches
};

std::string_view name(Mode mode);

/// @throws std::invalid_argument naming the value and the two that exist
Mode mode_from(std::string_view name);

} // namespace tremolo::coupler
