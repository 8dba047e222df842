#include "coupler/wire/frame.hpp"

#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <zlib.h>

namespace tremolo::coupler {
namespace {

using Code = FrameError::Code;

const FrameHeader header{
    .session = 0x0123456789abcdef, .sender = 2, .field = 1, .step = 40, .steps = 3, .count = 2};
const ExpectedFrame expected{
    .session = header.session, .sender = 2, .field = 1, .step = 40, .count = 2, .most_steps = 8};
const std::vector<double> values{1.0, -2.5, 3e-300, 4e300, -0.0, 6.0};

Code error_of(const std::vector<std::byte>& bytes, const ExpectedFrame& what = expected) {
  const auto decoded = decode(bytes, what);
  if (const auto* error = std::get_if<FrameError>(&decoded))
    return error->code;
  ADD_FAILURE() << "the frame was accepted";
  return Code::size;
}

template <typename T>
void overwrite(std::vector<std::byte>& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// What a sender with a wrong idea, but a right checksum, would send.
template <typename T>
std::vector<std::byte> sealed_with(std::size_t at, T value) {
  auto bytes = encode(header, values);
  overwrite(bytes, at, value);
  overwrite(bytes, 40, std::uint32_t{0});
  const auto crc = crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  overwrite(bytes, 40, static_cast<std::uint32_t>(crc));
  return bytes;
}

TEST(Frame, RoundTripKeepsEveryBit) {
  const auto bytes = encode(header, values);
  const auto decoded = decode(bytes, expected);
  ASSERT_TRUE(std::holds_alternative<Frame>(decoded)) << std::get<FrameError>(decoded).text;
  const auto& frame = std::get<Frame>(decoded);
  EXPECT_EQ(frame.header.step, 40U);
  EXPECT_EQ(frame.header.steps, 3U);
  ASSERT_EQ(frame.body.size(), values.size() * sizeof(double));
  EXPECT_EQ(std::memcmp(frame.body.data(), values.data(), frame.body.size()), 0);
}

TEST(Frame, LiesAsDocumented) {
  const auto bytes = encode(header, values);
  ASSERT_EQ(bytes.size(), 64U + 6 * 8);
  const std::vector<unsigned> start{'T',  'R',  'M', 'L', 2, 0, 1, 0, 0xef, 0xcd, 0xab, 0x89, 0x67, 0x45,
                                    0x23, 0x01, 2,   0,   0, 0, 1, 0, 0,    0,    40,   0,    0,    0,
                                    0,    0,    0,   0,   3, 0, 0, 0, 2,    0,    0,    0};
  for (std::size_t i = 0; i < start.size(); ++i)
    EXPECT_EQ(std::to_integer<unsigned>(bytes[i]), start[i]) << "byte " << i;
  for (std::size_t i = 44; i < 64; ++i)
    EXPECT_EQ(bytes[i], std::byte{0}) << "byte " << i;
}

TEST(Frame, EveryFlippedBitIsRefused) {
  const auto good = encode(header, values);
  for (std::size_t i = 0; i < good.size(); ++i)
    for (unsigned bit = 0; bit < 8; ++bit) {
      auto bytes = good;
      bytes[i] ^= std::byte{1} << bit;
      EXPECT_TRUE(std::holds_alternative<FrameError>(decode(bytes, expected)))
          << "byte " << i << " bit " << bit;
    }
}

TEST(Frame, EveryLengthButTheRightOneIsRefused) {
  auto bytes = encode(header, values);
  bytes.push_back(std::byte{0});
  EXPECT_EQ(error_of(bytes), Code::size);
  for (bytes.pop_back(); !bytes.empty();) {
    bytes.pop_back();
    EXPECT_EQ(error_of(bytes), Code::size);
  }
}

TEST(Frame, EveryWrongFieldIsRefusedByNameEvenWithARightChecksum) {
  EXPECT_EQ(error_of(sealed_with(0, 'X')), Code::magic);
  EXPECT_EQ(error_of(sealed_with(4, std::uint16_t{1})), Code::version);
  EXPECT_EQ(error_of(sealed_with(6, std::uint16_t{2})), Code::units);
  EXPECT_EQ(error_of(sealed_with(8, header.session + 1)), Code::session);
  EXPECT_EQ(error_of(sealed_with(16, std::uint32_t{3})), Code::sender);
  EXPECT_EQ(error_of(sealed_with(20, std::uint32_t{0})), Code::field);
  EXPECT_EQ(error_of(sealed_with(24, std::uint64_t{39})), Code::step);
  EXPECT_EQ(error_of(sealed_with(24, std::uint64_t{41})), Code::step);
  EXPECT_EQ(error_of(sealed_with(32, std::uint32_t{0})), Code::steps);
  EXPECT_EQ(error_of(sealed_with(32, std::uint32_t{9})), Code::steps);
  EXPECT_EQ(error_of(sealed_with(32, std::uint32_t{2})), Code::size);
  EXPECT_EQ(error_of(sealed_with(36, std::uint32_t{3})), Code::count);
  EXPECT_EQ(error_of(sealed_with(63, std::uint8_t{1})), Code::reserved);
  EXPECT_EQ(error_of(sealed_with(64, std::numeric_limits<double>::quiet_NaN())), Code::not_finite);
  EXPECT_EQ(error_of(sealed_with(104, -std::numeric_limits<double>::infinity())), Code::not_finite);
}

TEST(Frame, WrongChecksumIsRefused) {
  auto bytes = encode(header, values);
  overwrite(bytes, 40, std::uint32_t{0});
  EXPECT_EQ(error_of(bytes), Code::crc);
}

TEST(Frame, RepeatedFrameIsRefused) {
  auto next = expected;
  next.step = header.step + header.steps;
  EXPECT_EQ(error_of(encode(header, values), next), Code::step);
}

TEST(Frame, ForgedLengthDoesNotOverflow) {
  auto huge = expected;
  huge.most_steps = huge.count = 0xffffffff;
  auto forged = header;
  forged.steps = forged.count = 0xffffffff;
  EXPECT_EQ(error_of(encode(forged, values), huge), Code::size);
}

TEST(Frame, ErrorTellsWhatWasFoundAndExpected) {
  const auto decoded = decode(sealed_with(24, std::uint64_t{41}), expected);
  EXPECT_EQ(std::get<FrameError>(decoded).text, "first step is 41, expected 40");
}

} // namespace
} // namespace tremolo::coupler
