#pragma once

// The status of a run: an attribute of fixed length at the root, overwritten in place.

#include "results/hdf5/hdf5_write.hpp"

#include <string_view>

namespace tremolo::results {

inline constexpr std::string_view status_running = "running";
inline constexpr std::string_view status_complete = "complete";

/// "aborted: reason"
std::string aborted_status(std::string_view reason);

/// Reserves the attribute.
void create_status(Place root);

/// Overwrites the attribute; a text over 511 bytes is cut.
void set_status(Place root, std::string_view status);

} // namespace tremolo::results
