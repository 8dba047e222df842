// Seeded mutations of valid frames. None may be accepted, unless the mutation gave back the very bytes.

#include "coupler/wire/frame.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/repetitions.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <zlib.h>

namespace tremolo::coupler {
namespace {

constexpr int frames = tremolo::test_support::repetitions(500'000); // in each of two tests
constexpr unsigned seed = 20261121;

const FrameHeader header{.session = 77, .sender = 1, .field = 0, .step = 128, .steps = 2, .count = 20};
const ExpectedFrame expected{.session = 77, .sender = 1, .step = 128, .count = 20, .most_steps = 64};

class Mutator {
public:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  std::byte any_byte() { return static_cast<std::byte>(below(256)); }

  std::vector<std::byte> mutate(std::vector<std::byte> bytes) {
    for (std::size_t n = 1 + below(4); n > 0; --n)
      mutate_once(bytes);
    return bytes;
  }

private:
  void mutate_once(std::vector<std::byte>& bytes) {
    if (bytes.empty())
      return;
    const auto at = static_cast<std::ptrdiff_t>(below(bytes.size()));
    switch (below(6)) {
    case 0:
      bytes[static_cast<std::size_t>(at)] ^= std::byte{1} << below(8);
      break;
    case 1:
      bytes[static_cast<std::size_t>(at)] = any_byte();
      break;
    case 2:
      bytes.resize(below(bytes.size() + 64), any_byte());
      break;
    case 3:
      bytes.erase(bytes.begin() + at);
      break;
    case 4:
      bytes.insert(bytes.begin() + at, any_byte());
      break;
    default:
      std::rotate(bytes.begin(), bytes.begin() + at, bytes.end());
    }
  }

  std::mt19937_64 random_{seed};
};

TEST(FrameFuzz, NoMutatedFrameIsAccepted) {
  std::vector<double> values(40);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = 0.1 * static_cast<double>(i) - 1.0;
  const auto good = encode(header, values);
  Mutator mutator;
  int unchanged = 0;
  for (int i = 0; i < frames; ++i) {
    const auto bytes = mutator.mutate(good);
    const bool accepted = std::holds_alternative<Frame>(decode(bytes, expected));
    unchanged += bytes == good ? 1 : 0;
    ASSERT_EQ(accepted, bytes == good) << "seed " << seed << ", frame " << i;
  }
  EXPECT_LT(unchanged, frames / 100) << "the mutations do not mutate";
}

/// The same, but with the checksum made right: only the comparison with what is expected stands in the way.
TEST(FrameFuzz, NoMutatedHeaderIsAcceptedWithARightChecksum) {
  const auto good = encode(header, std::vector<double>(40, 1.0));
  Mutator mutator;
  for (int i = 0; i < frames; ++i) {
    auto bytes = good;
    for (std::size_t n = 1 + mutator.below(3); n > 0; --n)
      bytes[mutator.below(frame_header_size)] = mutator.any_byte();
    std::fill_n(bytes.begin() + 40, 4, std::byte{0});
    const auto crc =
        static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
    std::memcpy(bytes.data() + 40, &crc, sizeof crc);
    const bool accepted = std::holds_alternative<Frame>(decode(bytes, expected));
    ASSERT_EQ(accepted, bytes == good) << "seed " << seed << ", frame " << i;
  }
}

/// What libFuzzer (frame_fuzzer.cpp) starts from and has found worth keeping: none but the valid frames pass.
TEST(FrameFuzz, CorpusIsRefusedButForTheValidFrames) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_dir() + "/tests/fuzz/coupler/corpus")) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    const bool accepted = std::holds_alternative<Frame>(decode(std::as_bytes(std::span(text)), expected));
    EXPECT_EQ(accepted, entry.path().filename().string().starts_with("valid")) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 10);
}

} // namespace
} // namespace tremolo::coupler
