// The same participants as threads of one process: the same bits, and the same message for any way to fail
// that leaves the process alive.

#include "coupled_run.hpp"
#include "toy_process.hpp"

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <utility>

namespace tremolo::coupler {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class RunInProcess : public CoupledRun {
protected:
  LaunchOptions threads(const std::string& misdeeds, Mode mode = Mode::window) {
    auto what = options(misdeeds, mode);
    what.transport = Transport::inproc;
    for (auto& process : what.processes)
      process.main = toy_process;
    return what;
  }
};

TEST_F(RunInProcess, GivesTheBitsOfProcesses) {
  for (const Mode mode : {Mode::window, Mode::lockstep}) {
    launch(options("", mode));
    const auto processes = tractions();
    const auto summaries = launch(threads("", mode));
    EXPECT_TRUE(bytes_of(processes) == bytes_of(tractions()));
    ASSERT_EQ(summaries.size(), 3U);
    for (const auto& summary : summaries) {
      EXPECT_GT(summary.cpu_seconds, 0.0);
      EXPECT_LE(summary.cpu_seconds, summary.wall_seconds);
      EXPECT_FALSE(summary.report.timeline.activities.empty());
    }
  }
  EXPECT_EQ(notes_, "");
}

TEST_F(RunInProcess, FailsWithTheMessageOfProcesses) {
  for (const std::string misdeed :
       {"right throws 64\n", "domain throws 64\n", "left nan 70\n", "domain nan 20\n", "domain beyond 0\n"}) {
    const auto by_processes = failure(options(misdeed));
    EXPECT_EQ(by_processes, failure(threads(misdeed))) << misdeed;
    EXPECT_EQ(exit_status_, 1);
  }
}

TEST_F(RunInProcess, AThreadThatDoesNotReactIsNamedAtTheStepDeadline) {
  auto what = threads("right stuck 100\n");
  what.deadlines.step = 1.0;
  EXPECT_THAT(failure(what),
              AllOf(HasSubstr("domain 'domain' waits for source 'right', field 'total', step 64"),
                    HasSubstr("'right' did not react")));
}

TEST_F(RunInProcess, InterruptEndsAllInOrder) {
  ends_on_interrupt(threads("domain slow 0\n"));
}

} // namespace
} // namespace tremolo::coupler
