#include "base/own_process.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <stdexcept>
#include <vector>

namespace tremolo {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr ProcessLimits limits{.memory_bytes = std::uint64_t{1} << 28, .cpu_seconds = 1};

TEST(OwnProcess, ReturnsTheAnswer) {
  const std::string long_answer(300'000, 'x');
  EXPECT_EQ(in_own_process([&] { return long_answer; }, limits), long_answer);
  EXPECT_EQ(in_own_process([] { return std::string(); }, limits), "");
}

TEST(OwnProcess, PassesAnErrorOn) {
  const auto fail = []() -> std::string { throw std::runtime_error("/energy is not what was written"); };
  EXPECT_THAT([&] { in_own_process(fail, limits); },
              ThrowsMessage<std::runtime_error>("/energy is not what was written"));
}

TEST(OwnProcess, OutlivesACrash) {
  const auto crash = []() -> std::string {
    std::raise(SIGSEGV);
    return "";
  };
  EXPECT_THAT([&] { in_own_process(crash, limits); },
              ThrowsMessage<std::runtime_error>(HasSubstr("ends with signal 11")));
}

TEST(OwnProcess, EndsWhatNeverEnds) {
  const auto spin = []() -> std::string {
    for (volatile bool for_ever = true; for_ever;) {
    }
    return "";
  };
  EXPECT_THAT([&] { in_own_process(spin, limits); },
              ThrowsMessage<std::runtime_error>(HasSubstr("longer than 1 s")));
}

} // namespace
} // namespace tremolo
