// The whole program in both exchange modes: the result files hold the same bits.

#include "results/run_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
#include <string>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

/// The flat box on a mesh coarse enough for a test.
std::string coarse_box() {
  std::ifstream in(fs::path(TREMOLO_SOURCE_DIR) / "cases/halfspace_box/case.toml");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return std::regex_replace(text, std::regex("\nsize = [0-9.]+"), "\nsize = 4.0");
}

TEST(ExchangeModes, ResultFilesHoldTheSameBits) {
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("tremolo_modes_{}", ::getpid());
  fs::create_directories(folder);
  std::ofstream(folder / "case.toml") << coarse_box();
  for (const std::string mode : {"window", "lockstep"}) {
    const auto command =
        fmt::format("{0}/tremolo run {1}/case.toml --out {1}/{2} --mode {2} > {1}/{2}.txt 2>&1",
                    TREMOLO_BIN_DIR, folder.string(), mode);
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
  }
  const tremolo::results::RunReader window(folder / "window/run.h5");
  const tremolo::results::RunReader lockstep(folder / "lockstep/run.h5");
  EXPECT_EQ(window.status(), "complete");
  EXPECT_EQ(lockstep.status(), "complete");
  ASSERT_GT(window.frame_times().size(), 1U);
  ASSERT_EQ(window.frame_times(), lockstep.frame_times());
  for (std::size_t frame = 0; frame < window.frame_times().size(); ++frame)
    for (const auto& field : window.frame_fields(frame))
      EXPECT_EQ(window.frame_field(frame, field).values, lockstep.frame_field(frame, field).values)
          << field << " in frame " << frame;
  for (const auto& monitor : window.monitors())
    EXPECT_EQ(window.series("/monitors/" + monitor).values, lockstep.series("/monitors/" + monitor).values);
  fs::remove_all(folder);
}

} // namespace
