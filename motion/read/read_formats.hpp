#pragma once

#include "motion/read/read.hpp"
#include "motion/read/text.hpp"

#include <optional>
#include <string_view>

namespace tremolo::motion {

/// NPTS and DT of a PEER file.
struct PeerHeader {
  double count = 0.0;
  double dt = 0.0; ///< s
};

/// From a line where each is followed by its number, or two numbers by the names in the same order.
std::optional<PeerHeader> peer_header(std::string_view line);

Record read_peer(Lines& lines, const ReadAs& as);
Record read_table(Lines& lines, const ReadAs& as);
Record read_hdf5(const std::filesystem::path& file, const ReadAs& as);

} // namespace tremolo::motion
