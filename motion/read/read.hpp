#pragma once

// Reading a motion from a file. The format is found in the file (motion/formats has a table of them), and in
// the extension where that says more: .AT2, .VT2 and .DT2 are PEER text, .csv is a table of time and values
// unless a network's header opens it.
//
// What a motion is follows from the name's extension and the header's words where they are unambiguous; what
// they leave open must be said by ReadAs. A header that may name a factor or a unit and is not wholly
// understood is refused.

#include "motion/record.hpp"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>

namespace tremolo::motion {

/// The caller's knowledge of the file. It settles what name and header leave open or contradict each other
/// in; it must not contradict both.
struct ReadAs {
  std::optional<Quantity> quantity;
  std::optional<Unit> unit;
  std::optional<MotionKind> kind;
  /// Chooses a component of a file with several: its number from 1, its name, or a part that only its name
  /// has.
  std::string component = {};
  /// Chooses the values of a table: the number from 1 of their column, its name, or a part that only its name
  /// has.
  std::string column = {};
};

/// More samples, or a longer line, are refused before they are read.
inline constexpr double most_samples = 2e7;
inline constexpr std::size_t longest_line = 65536; // characters

/// @throws RecordError if the file cannot be read, does not hold a motion, or leaves open what it is
Record read_record(const std::filesystem::path& file, const ReadAs& as = {});

/// The text formats, from a stream that can be rewound; `file` names it in messages and gives the extension.
Record parse_record(std::istream& stream, const std::filesystem::path& file, const ReadAs& as = {});

} // namespace tremolo::motion
