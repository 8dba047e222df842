#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tremolo {

/// CRC-32 as zlib's crc32() has it, and Python's zlib.crc32.
/// @param crc of the bytes before these; 0 at the start
std::uint32_t crc32(std::uint32_t crc, std::span<const std::byte> bytes);

} // namespace tremolo
