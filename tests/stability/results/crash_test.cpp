// A writer is killed at random moments; what it had flushed must still be there.

#include "../../unit/results/sample_run.hpp"

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <sys/wait.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <new>
#include <random>
#include <sstream>
#include <thread>

using namespace tremolo::results;
using namespace sample_run;

namespace {

/// A counter that a child increases and its parent reads.
class SharedCount {
public:
  SharedCount()
      : count_(new (::mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                           MAP_SHARED | MAP_ANONYMOUS, -1, 0)) std::atomic<int>(0)) {}
  ~SharedCount() { ::munmap(count_, sizeof(std::atomic<int>)); }
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;
  std::atomic<int>& operator*() { return *count_; }

private:
  std::atomic<int>* count_;
};

[[noreturn]] void write_for_ever(const std::filesystem::path& file, SharedCount& flushed) {
  RunWriter run(file, description);
  TimeSeries& toe = run.add_series("/monitors/toe", monitor_columns, monitor_units);
  for (std::size_t frame = 0;; ++frame) {
    toe.append(monitor_row(frame));
    write_frame(run, frame);
    ++*flushed;
  }
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Crash, KilledWriterLeavesEveryFlushedFrame) {
  const auto seed = std::random_device{}();
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::printf("seed %u\n", seed);
  std::uniform_int_distribution<int> microseconds(5'000, 120'000);
  for (int kill = 0; kill < 20; ++kill) {
    const Folder folder;
    SharedCount flushed;
    const pid_t child = ::fork();
    if (child == 0) {
      write_for_ever(folder / "run.h5", flushed);
    }
    while (*flushed < 1) {
      std::this_thread::yield();
    }
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);

    const RunReader run(folder / "run.h5");
    EXPECT_EQ(run.status(), "running");
    ASSERT_GE(run.frame_times().size(), static_cast<std::size_t>(*flushed));
    for (std::size_t frame = 0; frame < run.frame_times().size(); ++frame) {
      ASSERT_EQ(run.frame_field(frame, "stress").values, filled(frame, 2, 4 * particles(frame)));
    }
    const SeriesData toe = run.series("/monitors/toe");
    ASSERT_GE(toe.rows(), static_cast<std::size_t>(*flushed));
    ASSERT_EQ(toe.values[(toe.rows() - 1) * 9], monitor_row(toe.rows() - 1)[0]);

    std::stringstream xdmf;
    xdmf << std::ifstream(folder / "run.xdmf").rdbuf();
    EXPECT_NE(xdmf.str().find("</Xdmf>"), std::string::npos);
    EXPECT_GE(count_of(xdmf.str(), "<Time "), static_cast<std::size_t>(*flushed));
    EXPECT_LE(count_of(xdmf.str(), "<Time "), run.frame_times().size());
  }
}

} // namespace
