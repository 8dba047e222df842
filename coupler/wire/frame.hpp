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

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tremolo::coupler {

inline constexpr std::uint16_t protocol_version = 2;
inline constexpr std::size_t frame_header_size = 64;

struct FrameHeader {
  std::uint64_t session = 0;
  std::uint32_t sender = 0;
  std::uint32_t field = 0;
  std::uint64_t step = 0; ///< first step
  std::uint32_t steps = 0;
  std::uint32_t count = 0; ///< values per step
};

/// The frame that the receiver expects next.
struct ExpectedFrame {
  std::uint64_t session = 0;
  std::uint32_t sender = 0;
  std::uint32_t field = 0;
  std::uint64_t step = 0; ///< exactly last + 1
  std::uint32_t count = 0;
  std::uint32_t most_steps = 0; ///< the credit: no more was requested
};

/// A frame as it lies in the bytes it came in, which must outlive it.
struct Frame {
  FrameHeader header;
  std::uint32_t crc = 0;
  std::span<const std::byte> body; ///< steps x count float64, not aligned

  [[nodiscard]] std::vector<double> values() const;

  /// So many values from an index on.
  template <std::size_t n>
  [[nodiscard]] std::array<double, n> values(std::size_t first) const {
    std::array<double, n> some;
    std::memcpy(some.data(), body.data() + first * sizeof(double), sizeof some);
    return some;
  }
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

/// Writes the header of a frame whose values stand in its bytes already.
/// @param bytes frame_header_size, then header.steps x header.count float64
void seal(const FrameHeader& header, std::span<std::byte> bytes);

/// @param values header.steps x header.count numbers
std::vector<std::byte> encode(const FrameHeader& header, std::span<const double> values);

/// A frame that is being made: room for its header and values in the memory that will be sent.
class FrameDraft {
public:
  /// @param values of all steps, not yet set
  explicit FrameDraft(std::size_t values)
      : size_(values), memory_(std::make_unique_for_overwrite<double[]>(header_values + values)) {}

  [[nodiscard]] std::span<double> values() { return {memory_.get() + header_values, size_}; }
  /// Header and values.
  [[nodiscard]] std::span<std::byte> bytes() {
    return std::as_writable_bytes(std::span(memory_.get(), header_values + size_));
  }
  /// The memory, to be given back with delete[].
  [[nodiscard]] double* release() { return memory_.release(); }

private:
  static constexpr std::size_t header_values = frame_header_size / sizeof(double);
  std::size_t size_;
  std::unique_ptr<double[]> memory_;
};

/// Pure: no state, no I/O; never reads outside bytes whatever they hold.
std::variant<Frame, FrameError> decode(std::span<const std::byte> bytes, const ExpectedFrame& expected);

/// The index of the first value that is not finite, if any.
/// @param values float64, not aligned
std::optional<std::size_t> first_not_finite(std::span<const std::byte> values);

/// A frame that decode() has accepted or encode() has made.
Frame opened(std::span<const std::byte> bytes);

/// The sender and field a frame claims, to find out what to expect of it; nothing else of it is to be
/// believed.
struct FrameOrigin {
  std::uint32_t sender = 0;
  std::uint32_t field = 0;
};
/// @returns an origin of no one (both 0xffffffff) for bytes that are too short
FrameOrigin claimed_origin(std::span<const std::byte> bytes);

} // namespace tremolo::coupler
