#pragma once

// The formats of text files, in one table.

#include "motion/formats/trace.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::motion {

/// The first lines of a file.
struct Head {
  std::filesystem::path file;
  std::vector<std::string> lines;

  /// The line of this number, from 1; empty beyond the end.
  std::string_view line(std::size_t number) const {
    return number <= lines.size() ? std::string_view(lines[number - 1]) : std::string_view();
  }
  /// Whether a line says this, in capitals.
  bool holds(std::string_view capitals) const;
};

struct Format {
  const char* name;
  bool (*recognises)(const Head& head);
  /// Empty if the file cannot become a motion.
  std::vector<Trace> (*read)(Lines& lines, const ReadAs& as);
  /// Says what the format is and what to do instead, where it is not read.
  const char* instead = nullptr;
  /// Whether --column chooses, not --component.
  bool columns = false;
  /// Whether a unit that is not named is PEER's.
  bool peer_units = false;
};

/// The formats in the order in which they are tried; the last one accepts any text.
std::span<const Format> formats();

std::vector<Trace> read_peer(Lines& lines, const ReadAs& as);
std::vector<Trace> read_table(Lines& lines, const ReadAs& as);
std::vector<Trace> read_count_and_step(Lines& lines, const ReadAs& as);
std::vector<Trace> read_knet(Lines& lines, const ReadAs& as);
std::vector<Trace> read_smc(Lines& lines, const ReadAs& as);
std::vector<Trace> read_cosmos(Lines& lines, const ReadAs& as);
std::vector<Trace> read_csmip(Lines& lines, const ReadAs& as);
std::vector<Trace> read_csmip_pairs(Lines& lines, const ReadAs& as);
std::vector<Trace> read_bhrc(Lines& lines, const ReadAs& as);
std::vector<Trace> read_geonet(Lines& lines, const ReadAs& as);
std::vector<Trace> read_dyna(Lines& lines, const ReadAs& as);
std::vector<Trace> read_unam(Lines& lines, const ReadAs& as);
std::vector<Trace> read_cwb(Lines& lines, const ReadAs& as);
std::vector<Trace> read_nsmn(Lines& lines, const ReadAs& as);

/// NPTS and DT of a PEER file.
struct PeerHeader {
  double count = 0.0;
  double dt = 0.0; ///< s
};

/// Reads a line in which each name is followed by its number, or two numbers by the names in that order.
std::optional<PeerHeader> peer_header(std::string_view line);

/// Reads a line of exactly two numbers, one a whole number of samples and the other a step: "4684 0.0100".
std::optional<PeerHeader> count_and_step(std::string_view line);

/// Samples to the end of the file, in free columns or in fixed ones that touch.
/// @throws RecordError where there are not `count` of them, or one is no number
void read_samples(Lines& lines, std::size_t count, std::vector<double>& samples);

inline constexpr const char* decimal_commas =
    "decimal commas: numbers are written with a point, 0.123 instead of 0,123";

/// The common step of printed times from 0 on, s.
/// @throws RecordError where the times are not equally spaced, with the line
double common_step(const std::vector<double>& times, const std::vector<std::size_t>& line_of,
                   const std::filesystem::path& file);

/// The name of a binary format of seismologists that is not read, by the file's first bytes; empty for
/// others.
std::string_view binary_format(std::string_view head);

Record read_hdf5(const std::filesystem::path& file, const ReadAs& as);

} // namespace tremolo::motion
