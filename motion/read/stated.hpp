#pragma once

// Statements of a file about itself, in its name and its header, combined with those of the caller.

#include "motion/read/read.hpp"
#include "motion/read/units.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace tremolo::motion {

/// Steps of strong motions, s; a finer or coarser one is a mistake, and would need unlimited memory.
inline constexpr double finest_step = 1e-5;
inline constexpr double coarsest_step = 10.0;

/// m/s2, m/s or m; no motion of the ground comes near.
inline constexpr double largest_sample = 1e6;

/// Statements by the file's extension: .AT2 acceleration, .VT2 velocity, .DT2 displacement.
Stated stated_by_name(const std::filesystem::path& file);

/// Statements of a header line of a PEER file, e.g. "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS:
/// ...", which names the units; empty for other lines.
Stated stated_in_peer(std::string_view line);

/// PEER's own unit of a quantity: g, cm/s, cm.
Unit peer_unit(Quantity quantity);

/// Puts unit, kind and what is to be said of the unit into the record, whose samples are in the unit that the
/// header states, and takes the unit's factor.
/// @param fallback_to_peer a missing unit is PEER's
/// @throws RecordError that says what is missing or contradicts, or which sample is out of range
void settle(Record& record, const Stated& by_name, const Stated& by_header, const ReadAs& as,
            bool fallback_to_peer, const std::string& place);

} // namespace tremolo::motion
