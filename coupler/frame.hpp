#pragma once

// The data frame: a 64-byte little-endian header and raw float64 (docs/wire-protocol.md).
//
//     offset size
//      0     4   magic "TRML"
//      4     2   protocol version
//      6     2   units: 1 = SI (m/s, Pa and their rates)
//      8     8   session, the random number of the run
//     16     4   sender, its number from the handshake (0 is the hub)
//     20     4   field, one of the sender's
//     24     8   first step in the frame
//     32     4   steps in the frame
//     36     4   count, float64 values per step
//     40     4   CRC-32 (zlib) of header and body, these four bytes taken as zero
//     44    20   reserved, zero
//
// A frame is used only if every one of these is exactly what the receiver expects next and every value is
// finite, so no stale, foreign, torn or repeated data can be read as new.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tremolo::coupler {

inline constexpr std::uint16_t protocol_version = 1;
inline constexpr std::size_t frame_header_size = 64;

struct FrameHeader {
  std::uint64_t session = 0;
  std::uint32_t sender = 0;
  std::uint32_t field = 0;
  std::uint64_t step = 0; ///< first step
  std::uint32_t steps = 0;
  std::uint32_t count = 0; ///< values per step
};

/// What the receiver will take next.
struct ExpectedFrame {
  std::uint64_t session = 0;
  std::uint32_t sender = 0;
  std::uint32_t field = 0;
  std::uint64_t step = 0; ///< exactly last + 1
  std::uint32_t count = 0;
  std::uint32_t most_steps = 0; ///< the credit: more was not asked for
};

struct Frame {
  FrameHeader header;
  std::vector<double> values; ///< steps x count
};

struct FrameError {
  enum class Code {
    size,
    magic,
    version,
    units,
    session,
    sender,
    field,
    step,
    steps,
    count,
    reserved,
    crc,
    not_finite
  };
  Code code;
  std::string text; ///< what was found and what was expected
};

/// @param values header.steps x header.count numbers
std::vector<std::byte> encode(const FrameHeader& header, std::span<const double> values);

/// Pure: no state, no I/O; never reads outside bytes whatever they hold.
std::variant<Frame, FrameError> decode(std::span<const std::byte> bytes, const ExpectedFrame& expected);

/// A frame that decode() has accepted or encode() has made, without its values being copied.
struct OpenedFrame {
  FrameHeader header;
  std::uint32_t crc = 0;
  std::span<const std::byte> body; ///< float64, not aligned
};
OpenedFrame opened(std::span<const std::byte> bytes);

/// The sender and field a frame claims, to find out what to expect of it; nothing else of it is to be
/// believed.
struct FrameOrigin {
  std::uint32_t sender = 0;
  std::uint32_t field = 0;
};
/// @returns an origin of no one (both 0xffffffff) for bytes that are too short
FrameOrigin claimed_origin(std::span<const std::byte> bytes);

} // namespace tremolo::coupler
