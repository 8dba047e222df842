#include "base/crc32.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>
#include <string_view>
#include <vector>

namespace tremolo {
namespace {

std::uint32_t by_zlib(std::uint32_t crc, std::span<const std::byte> bytes) {
  return static_cast<std::uint32_t>(crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

TEST(Crc32, HasTheCheckValueOfTheCatalogue) {
  const std::string_view digits = "123456789";
  EXPECT_EQ(crc32(0, std::as_bytes(std::span(digits))), 0xcbf43926U);
}

TEST(Crc32, IsThatOfZlibAtEveryLengthAlignmentAndStart) {
  std::mt19937 random(7);
  std::vector<std::byte> bytes(700);
  for (auto& byte : bytes)
    byte = static_cast<std::byte>(random());
  for (std::size_t length = 0; length <= 600; ++length) {
    const auto part = std::span<const std::byte>(bytes).subspan(length % 17, length);
    const auto start = length % 2 == 0 ? 0U : static_cast<std::uint32_t>(random());
    ASSERT_EQ(crc32(start, part), by_zlib(start, part)) << length << " bytes from " << length % 17;
  }
}

} // namespace
} // namespace tremolo
