#pragma once

// Readers. A file is HDF5 by its signature; .AT2, .VT2 and .DT2 are PEER text, .csv is a table of time and
// value; any other name is PEER text where one of the first lines holds NPTS and DT, otherwise such a table.
//
// PEER:  header lines, one with NPTS and DT ("NPTS= 2000, DT= .0200 SEC", "4096 0.0100 NPTS, DT", any
//        spelling), then the samples, in fixed or free columns.
// Table: "time (s), acceleration (g)" (optional, may be commented with #), then a time and a value a line,
//        separated by comma, semicolon or blanks; times from 0 in equal steps.
// HDF5:  dataset "motion" of one dimension with attributes dt (s), unit, and optionally quantity and kind:
//            f["motion"] = samples
//            f["motion"].attrs.update(dt=0.005, unit="m/s2", kind="outcrop")
//
// What a motion is follows from the name's extension and the header's words where they are unambiguous; what
// they leave open must be said by ReadAs.

#include "motion/record.hpp"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <optional>

namespace tremolo::motion {

/// What the caller knows of the file. It settles what name and header leave open, or contradict each other
/// in; it may not contradict both.
struct ReadAs {
  std::optional<Quantity> quantity;
  std::optional<Unit> unit;
  std::optional<MotionKind> kind;
};

/// More samples, or a longer line, are refused before they are read.
inline constexpr double most_samples = 2e7;
inline constexpr std::size_t longest_line = 65536; // characters

/// @throws RecordError if the file cannot be read, does not hold a motion, or leaves open what it is
Record read_record(const std::filesystem::path& file, const ReadAs& as = {});

/// The text formats, from a stream that can be rewound; `file` names it in messages and gives the extension.
Record parse_record(std::istream& stream, const std::filesystem::path& file, const ReadAs& as = {});

} // namespace tremolo::motion
