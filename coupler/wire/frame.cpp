#include "coupler/wire/frame.hpp"

#include "base/crc32.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <optional>

namespace tremolo::coupler {

static_assert(std::endian::native == std::endian::little, "frames are copied as they lie in memory");

namespace {

constexpr std::array<char, 4> magic{'T', 'R', 'M', 'L'};
constexpr std::uint16_t units_si = 1;

namespace offset {
constexpr std::size_t magic = 0;
constexpr std::size_t version = 4;
constexpr std::size_t units = 6;
constexpr std::size_t session = 8;
constexpr std::size_t sender = 16;
constexpr std::size_t field = 20;
constexpr std::size_t step = 24;
constexpr std::size_t steps = 32;
constexpr std::size_t count = 36;
constexpr std::size_t crc = 40;
constexpr std::size_t reserved = 44;
} // namespace offset

template <typename T>
void put(std::span<std::byte> bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

template <typename T>
T get(std::span<const std::byte> bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::uint32_t frame_crc(std::span<const std::byte> bytes) {
  constexpr std::array<std::byte, 4> zero{};
  std::uint32_t crc = crc32(0, bytes.first(offset::crc));
  crc = crc32(crc, zero);
  return crc32(crc, bytes.subspan(offset::reserved));
}

double value_at(std::span<const std::byte> body, std::size_t index) {
  return get<double>(body, index * sizeof(double));
}

using Code = FrameError::Code;

template <typename T>
FrameError mismatch(Code code, std::string_view what, T found, T expected) {
  return {code, fmt::format("{} is {}, expected {}", what, found, expected)};
}

FrameHeader header_of(std::span<const std::byte> bytes) {
  return {.session = get<std::uint64_t>(bytes, offset::session),
          .sender = get<std::uint32_t>(bytes, offset::sender),
          .field = get<std::uint32_t>(bytes, offset::field),
          .step = get<std::uint64_t>(bytes, offset::step),
          .steps = get<std::uint32_t>(bytes, offset::steps),
          .count = get<std::uint32_t>(bytes, offset::count)};
}

std::variant<FrameHeader, FrameError> decode_header(std::span<const std::byte> bytes,
                                                    const ExpectedFrame& expected) {
  if (bytes.size() < frame_header_size)
    return mismatch(Code::size, "length in bytes", bytes.size(), frame_header_size);
  if (std::memcmp(bytes.data() + offset::magic, magic.data(), magic.size()) != 0)
    return FrameError{Code::magic, "not a data frame: it does not begin with TRML"};
  const auto version = get<std::uint16_t>(bytes, offset::version);
  if (version != protocol_version)
    return mismatch(Code::version, "protocol version", version, protocol_version);
  const auto units = get<std::uint16_t>(bytes, offset::units);
  if (units != units_si)
    return mismatch(Code::units, "unit tag", units, units_si);

  const FrameHeader header = header_of(bytes);
  if (header.session != expected.session)
    return mismatch(Code::session, "session", header.session, expected.session);
  if (header.sender != expected.sender)
    return mismatch(Code::sender, "sender", header.sender, expected.sender);
  if (header.field != expected.field)
    return mismatch(Code::field, "field", header.field, expected.field);
  if (header.step != expected.step)
    return mismatch(Code::step, "first step", header.step, expected.step);
  if (header.count != expected.count)
    return mismatch(Code::count, "count of values per step", header.count, expected.count);
  if (header.steps == 0 || header.steps > expected.most_steps)
    return FrameError{Code::steps,
                      fmt::format("holds {} steps, expected 1 to {}", header.steps, expected.most_steps)};
  return header;
}

} // namespace

void seal(const FrameHeader& header, std::span<std::byte> bytes) {
  std::memset(bytes.data(), 0, frame_header_size);
  std::memcpy(bytes.data() + offset::magic, magic.data(), magic.size());
  put(bytes, offset::version, protocol_version);
  put(bytes, offset::units, units_si);
  put(bytes, offset::session, header.session);
  put(bytes, offset::sender, header.sender);
  put(bytes, offset::field, header.field);
  put(bytes, offset::step, header.step);
  put(bytes, offset::steps, header.steps);
  put(bytes, offset::count, header.count);
  put(bytes, offset::crc, frame_crc(bytes));
}

std::vector<std::byte> encode(const FrameHeader& header, std::span<const double> values) {
  std::vector<std::byte> bytes(frame_header_size + values.size_bytes());
  std::ranges::copy(std::as_bytes(values), bytes.begin() + frame_header_size);
  seal(header, bytes);
  return bytes;
}

std::variant<Frame, FrameError> decode(std::span<const std::byte> bytes, const ExpectedFrame& expected) {
  const auto checked = decode_header(bytes, expected);
  if (const auto* error = std::get_if<FrameError>(&checked))
    return *error;
  const auto& header = std::get<FrameHeader>(checked);

  const std::size_t size =
      frame_header_size + sizeof(double) * static_cast<std::size_t>(header.steps) * header.count;
  if (bytes.size() != size)
    return mismatch(Code::size, "length in bytes", bytes.size(), size);
  const auto reserved = bytes.subspan(offset::reserved, frame_header_size - offset::reserved);
  if (std::any_of(reserved.begin(), reserved.end(), [](std::byte b) { return b != std::byte{0}; }))
    return FrameError{Code::reserved, "reserved bytes of the header are not zero"};
  const auto crc = get<std::uint32_t>(bytes, offset::crc);
  if (const auto computed = frame_crc(bytes); crc != computed)
    return mismatch(Code::crc, "CRC-32", crc, computed);

  const Frame frame = opened(bytes);
  if (const auto bad = first_not_finite(frame.body))
    return FrameError{Code::not_finite,
                      fmt::format("value {} of step {} is {}", *bad % header.count,
                                  header.step + *bad / header.count, value_at(frame.body, *bad))};
  return frame;
}

std::vector<double> Frame::values() const {
  std::vector<double> numbers(body.size() / sizeof(double));
  std::ranges::copy(body, std::as_writable_bytes(std::span(numbers)).begin());
  return numbers;
}

std::optional<std::size_t> first_not_finite(std::span<const std::byte> values) {
  // Nearly always there is none: so that the loop over all needs no branch, it asks first whether any has all
  // bits of its exponent set.
  constexpr std::uint64_t exponent = 0x7ff0000000000000;
  std::uint64_t any = 0;
  for (std::size_t at = 0; at < values.size(); at += sizeof(double))
    any |= static_cast<std::uint64_t>((get<std::uint64_t>(values, at) & exponent) == exponent);
  if (any == 0)
    return std::nullopt;
  std::size_t index = 0;
  while (std::isfinite(value_at(values, index)))
    ++index;
  return index;
}

Frame opened(std::span<const std::byte> bytes) {
  return {header_of(bytes), get<std::uint32_t>(bytes, offset::crc), bytes.subspan(frame_header_size)};
}

FrameOrigin claimed_origin(std::span<const std::byte> bytes) {
  if (bytes.size() < frame_header_size)
    return {~0U, ~0U};
  return {get<std::uint32_t>(bytes, offset::sender), get<std::uint32_t>(bytes, offset::field)};
}

} // namespace tremolo::coupler
