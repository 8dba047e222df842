#pragma once

// Units as people write them beside the name of a column: "acc [milli-g]", "a (x 1e-3 g)", "%g", "cm/s/s",
// "10^-3 G", "percent of g", "G/10", "m s-2".
//
//     unit   = { factor } base [ / number ]
//     factor = number [ ^ number | / number ] | % | percent | milli | tenths | ...      (x and * between)
//     base   = g | gal | mg | length | length / time | length / time^2
//
// A factor in front of the unit belongs to it: samples in "0.1 g". What stands behind it ("(m/s^2) x 100") or
// makes the unit larger ("1000 g") may as well say what the samples were multiplied by, and is not
// understood.

#include "motion/record.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tremolo::motion {

/// Statements of a text about the samples that it belongs to.
struct Stated {
  std::optional<Quantity> quantity = std::nullopt;
  std::optional<ScaledUnit> unit = std::nullopt;
  std::optional<MotionKind> kind = std::nullopt;
  /// The text, where something in it may concern the unit and is not understood; there is no `unit` then.
  std::string strange = {};
};

/// Statements of a text that describes this motion alone, such as the name of a column. Contradictory words
/// are ignored.
/// @param strict_from  from this character on every word must be understood; before it only numbers, signs
///                     and words of factors are strange
Stated stated_in(std::string_view text, std::size_t strict_from = 0);

/// A text that is a unit and nothing else; nothing if it is not wholly understood.
std::optional<ScaledUnit> scaled_unit(std::string_view text);

/// Seconds in one of the unit of a first column, from its name: "time (s)", "t [ms]", "# Time". 1 without a
/// unit, nothing if the text is no name of a time.
std::optional<double> seconds_per_time(std::string_view text);

} // namespace tremolo::motion
