#pragma once

// A run of toys in a folder of its own, with the misdeeds that a test asks for.

#include "coupler/launch/launcher.hpp"

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tremolo::coupler {

namespace fs = std::filesystem;

class CoupledRun : public testing::Test {
protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / fmt::format("tremolo_{}_{}", test->name(), ::getpid());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  LaunchOptions options(const std::string& misdeeds, Mode mode = Mode::window) {
    std::ofstream(folder_ / "case") << misdeeds;
    return {.case_file = folder_ / "case",
            .out = folder_,
            .processes = {{"left", Role::source, TOY_PARTICIPANT},
                          {"right", Role::source, TOY_PARTICIPANT},
                          {"domain", Role::domain, TOY_PARTICIPANT}},
            .mode = mode,
            .on_progress = [](const Progress&) {},
            .note = [this](const std::string& line) { notes_ += line + "\n"; }};
  }

  /// The message of a run that fails, after which no process is left.
  std::string failure(const LaunchOptions& what) {
    std::string text;
    try {
      launch(what);
      ADD_FAILURE() << "the run did not fail";
    } catch (const RunFailed& error) {
      text = error.what();
      exit_status_ = error.exit_status();
    }
    for (const auto& process : what.processes) {
      pid_t pid = 0;
      std::ifstream(folder_ / (process.name + ".pid")) >> pid;
      EXPECT_TRUE(pid == 0 || (::kill(pid, 0) < 0 && errno == ESRCH)) << process.name << " is still there";
    }
    return text;
  }

  /// Ctrl-C as soon as the run shakes.
  void ends_on_interrupt(LaunchOptions what) {
    bool sent = false;
    what.on_progress = [&](const Progress& progress) {
      if (progress.stage == "shaking" && !std::exchange(sent, true))
        ::kill(::getpid(), SIGINT);
    };
    EXPECT_THAT(failure(what), testing::HasSubstr("interrupted by Ctrl-C"));
    EXPECT_EQ(exit_status_, 128 + SIGINT);
  }

  std::vector<eq6::Vector> tractions() const {
    const auto file = folder_ / "tractions.bin";
    std::vector<eq6::Vector> list(fs::file_size(file) / sizeof(eq6::Vector));
    std::ifstream(file, std::ios::binary)
        .read(reinterpret_cast<char*>(list.data()), static_cast<std::streamsize>(fs::file_size(file)));
    return list;
  }

  fs::path folder_;
  std::string notes_;
  int exit_status_ = 0;
};

inline std::string bytes_of(const std::vector<eq6::Vector>& list) {
  return {reinterpret_cast<const char*>(list.data()), list.size() * sizeof(eq6::Vector)};
}

} // namespace tremolo::coupler
