#pragma once

#include "mpm_domain/ranks/communicator.hpp"

namespace tremolo::cost {

/// Prints the time that messages and collective exchanges of several sizes take, as CSV. All ranks call it.
void time_messages(mpm_domain::Communicator& ranks);

} // namespace tremolo::cost
