#pragma once

// What a file says of itself, in its name and in its header, and what follows from that together with what
// the caller says.

#include "motion/read/read.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace tremolo::motion {

/// Steps of strong motions, s; a finer or coarser one is a mistake, and would ask for memory without end.
inline constexpr double finest_step = 1e-5;
inline constexpr double coarsest_step = 10.0;

struct Stated {
  std::optional<Quantity> quantity;
  std::optional<Unit> unit;
  std::optional<MotionKind> kind;
  std::string strange_unit; ///< announced as a unit, but not known
};

/// By extension: .AT2 acceleration, .VT2 velocity, .DT2 displacement.
Stated stated_by_name(const std::filesystem::path& file);

/// From a text that speaks of this motion alone, such as the name of a column, or what follows "IN UNITS OF".
/// Where words contradict each other they say nothing.
Stated stated_in(std::string_view text);

/// From a header line of a PEER file, e.g. "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: ...":
/// such a line names the units; others say nothing.
Stated stated_in_peer(std::string_view line);

/// PEER's own unit of a quantity: g, cm/s, cm.
Unit peer_unit(Quantity quantity);

/// Puts unit and kind into the record. @param fallback_to_peer a missing unit is PEER's
/// @throws RecordError that says what is missing or contradicts
void settle(Record& record, const Stated& by_name, const Stated& by_header, const ReadAs& as,
            bool fallback_to_peer, const std::string& place);

} // namespace tremolo::motion
