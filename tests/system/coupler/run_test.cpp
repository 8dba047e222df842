// Runs of real processes: that they end well with the right numbers, and that any way to fail ends all of
// them with a message that names the one who failed.

#include "coupled_run.hpp"
#include "toy_field.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <utility>

namespace tremolo::coupler {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

TEST_F(CoupledRun, BothModesAndBothTransportsGiveTheSameBitsAndTheRightTractions) {
  launch(options(""));
  const auto window = tractions();
  launch(options("", Mode::lockstep));
  const auto lockstep = tractions();
  auto over_tcp = options("");
  over_tcp.transport = Transport::tcp;
  launch(over_tcp);
  EXPECT_EQ(notes_, "");
  ASSERT_EQ(window.size(), toy::faces().size() * toy::steps);
  EXPECT_TRUE(bytes_of(window) == bytes_of(lockstep)) << "the modes differ";
  EXPECT_TRUE(bytes_of(window) == bytes_of(tractions())) << "the transports differ";

  const auto faces = toy::faces();
  const auto field = toy::field("total");
  // 4 sums of cubic Hermite errors in time, 5e-6 relative at this step, and in depth, on values of 1e5 Pa.
  const double tolerance = 5.0;
  for (int step = 0; step < toy::steps; ++step)
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const auto& face = faces[i];
      const double delay = field.slowness_x * (face.position.x - field.x_reference);
      const auto exact =
          eq6::boundary_traction(face.dashpot, toy::domain_velocity(i, step),
                                 toy::motion(face.position.y, toy::time(step) - delay), face.static_traction)
              .total();
      const auto found = window[static_cast<std::size_t>(step) * faces.size() + i];
      ASSERT_NEAR(found.x, exact.x, tolerance) << "step " << step << " face " << i;
      ASSERT_NEAR(found.y, exact.y, tolerance) << "step " << step << " face " << i;
    }
}

TEST_F(CoupledRun, SummaryHasTheReportsOfAll) {
  const auto summaries = launch(options(""));
  ASSERT_EQ(summaries.size(), 3U);
  EXPECT_EQ(summaries[0].report.passes.front().name, "fill");
  EXPECT_EQ(summaries[2].report.passes.front().name, "tractions");
  EXPECT_EQ(summaries[2].report.particle_updates, 1e6);
  EXPECT_GT(summaries[2].wall_seconds, 0.0);
}

TEST_F(CoupledRun, TheTimelineNamesTheSlowSource) {
  for (const Mode mode : {Mode::window, Mode::lockstep}) {
    // Before its first frame, so that no other's slowness can hide it.
    const auto summaries = launch(options("right late 0\n", mode));
    for (const auto& summary : summaries) {
      double total = 0.0;
      for (const auto& [activity, slices] : summary.report.timeline.activities)
        total += summary.report.timeline.seconds(activity);
      EXPECT_GE(total, summary.name == "left" ? 0.0 : 1.5) << summary.name; // left may start meanwhile
      EXPECT_LE(total, summary.wall_seconds) << summary.name;
    }
    EXPECT_GE(summaries[1].report.timeline.seconds(computing), 1.5);
    const auto& domain = summaries[2].report.timeline;
    EXPECT_GT(domain.seconds("waiting for right"), domain.seconds("waiting for left"));
    EXPECT_GT(domain.seconds(mapping), 0.0);
  }
}

TEST_F(CoupledRun, PauseWithinTheDeadlineChangesNothing) {
  launch(options(""));
  const auto smooth = tractions();
  launch(options("right pauses 100\n"));
  EXPECT_TRUE(bytes_of(smooth) == bytes_of(tractions()));
}

TEST_F(CoupledRun, KilledParticipantEndsTheRunAndIsNamed) {
  for (const Mode mode : {Mode::window, Mode::lockstep})
    for (const std::string victim : {"left", "right", "domain"}) {
      const auto text = failure(options(victim + " killed 120\n", mode));
      EXPECT_THAT(text, HasSubstr(fmt::format("'{}' was killed by signal 9", victim)));
      EXPECT_EQ(exit_status_, 1);
    }
}

TEST_F(CoupledRun, KilledBeforeOrAfterTheExchangeEndsTheRunToo) {
  for (const std::string moment : {"killed-before-hello", "killed-at-welcome", "killed-after-bye"})
    for (const std::string victim : {"left", "domain"}) {
      const auto text = failure(options(fmt::format("{} {} 0\n", victim, moment)));
      EXPECT_THAT(text, HasSubstr(fmt::format("'{}' was killed by signal 9", victim))) << moment;
    }
}

TEST_F(CoupledRun, SurvivorsAreGoneWithinTwoSecondsOfAKill) {
  failure(options("left killed 120\nright stuck 100\n")); // one that would never leave by itself
  EXPECT_LT(fs::file_time_type::clock::now() - fs::last_write_time(folder_ / "death"),
            std::chrono::seconds(2));
}

TEST_F(CoupledRun, ThrownErrorIsShownFromTheLog) {
  EXPECT_THAT(failure(options("right throws 64\n")),
              AllOf(HasSubstr("'right' exited with code 1"), HasSubstr("toy: the toy is broken")));
}

TEST_F(CoupledRun, SourceThatNeverStartsIsNamedAtTheConnectDeadline) {
  auto what = options("right absent 0\n");
  what.deadlines.connect = 0.6;
  EXPECT_THAT(failure(what), HasSubstr("no HELLO from source 'right' within 0.6 s"));
}

TEST_F(CoupledRun, StuckSourceIsNamedAtTheStepDeadline) {
  for (const Mode mode : {Mode::window, Mode::lockstep}) {
    auto what = options("right stuck 100\n", mode);
    what.deadlines.step = toy::brief;
    EXPECT_THAT(failure(what), HasSubstr("domain 'domain' waits for source 'right', field 'total', step 64"));
  }
}

TEST_F(CoupledRun, SourceThatRunsInCirclesIsNamedAtTheStepDeadlineThoughItBeats) {
  auto what = options("right circles 100\n");
  what.deadlines.step = toy::brief;
  EXPECT_THAT(failure(what), HasSubstr("domain 'domain' waits for source 'right', field 'total', step 64"));
}

TEST_F(CoupledRun, SourceThatReportsWorkMayTakeLongerThanTheStepDeadline) {
  auto what = options("right works 100\n"); // for twice as long
  what.deadlines.step = toy::brief;
  launch(what);
  EXPECT_THAT(notes_, HasSubstr("domain 'domain' waits for source 'right', field 'total', step 64"));
}

TEST_F(CoupledRun, StuckDomainIsNamedAtTheStepDeadline) {
  auto what = options("domain stuck 100\n");
  what.deadlines.step = toy::brief;
  EXPECT_THAT(failure(what),
              AllOf(HasSubstr("the hub waits for the velocities of step 64 of domain 'domain'"),
                    HasSubstr("its last sign of life")));
}

TEST_F(CoupledRun, ValuesThatAreNotFiniteAreRefused) {
  EXPECT_THAT(
      failure(options("left nan 70\n")),
      HasSubstr("source 'left', field 'total', step 70: stress syy at y = -40 m (point 0 of 81) is nan Pa"));
  for (const std::string huge : {"1e+200", "1e+308"})
    EXPECT_THAT(
        failure(options("left " + huge + " 70\n")),
        HasSubstr("source 'left', field 'total', step 70: stress syy at y = -40 m (point 0 of 81) is " +
                  huge + " Pa, allowed are -1e+10 to 1e+10 Pa"));
  EXPECT_THAT(failure(options("domain nan 20\n")),
              HasSubstr("domain 'domain', step 20: the velocity of face 5 is (nan"));
}

TEST_F(CoupledRun, AnotherCaseIsRefusedNamingBothSides) {
  EXPECT_THAT(failure(options("right other-case 0\n")),
              AllOf(HasSubstr("'right' (build "), HasSubstr("says case = "), HasSubstr("the hub (build "),
                    HasSubstr("line 1: 'another case' against 'right other-case 0'")));
  EXPECT_EQ(notes_, "") << "the cause is told twice";
}

TEST_F(CoupledRun, SecondProcessOfOneNameIsRefusedAndNamed) {
  const auto text = failure(options("right impostor 0\n"));
  EXPECT_THAT(text, AnyOf(HasSubstr("'right' exited with code 1"), HasSubstr("'left' exited with code 1")));
  EXPECT_THAT(text, HasSubstr("'left' is already taking part in this run"));
  EXPECT_THAT(notes_, HasSubstr("refused: 'left' is already taking part"));
}

TEST_F(CoupledRun, StrangersAndDoublesDoNotDisturbARunningExchange) {
  launch(options(""));
  const auto undisturbed = tractions();
  for (const Mode mode : {Mode::window, Mode::lockstep}) {
    notes_.clear();
    launch(options("domain disturbed 50\n", mode));
    EXPECT_TRUE(bytes_of(undisturbed) == bytes_of(tractions()));
    EXPECT_THAT(notes_, AllOf(HasSubstr("refused: 'domain' is already taking part"),
                              HasSubstr("refused: BYE before HELLO"),
                              HasSubstr("ignored 4096 bytes from a stranger")));
  }
}

TEST_F(CoupledRun, FaceBeyondTheSourceIsRefusedNamingBoth) {
  EXPECT_THAT(failure(options("domain beyond 0\n")),
              AllOf(HasSubstr("domain 'domain'"), HasSubstr("source 'left' does not cover the domain"),
                    HasSubstr("served from y = -40 to 0 m, but a face lies at x = 19.5, y = 50 m")));
}

TEST_F(CoupledRun, ProgramThatDoesNotExistIsToldAtOnce) {
  auto what = options("");
  what.processes[1].program = "/nonexistent/tremolo-wave";
  EXPECT_THROW(
      try { launch(what); } catch (const Error& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("cannot start 'right' as /nonexistent/tremolo-wave: No such file"));
        throw;
      },
      Error);
}

TEST_F(CoupledRun, InterruptEndsAllInOrder) {
  ends_on_interrupt(options("domain slow 0\n"));
}

} // namespace
} // namespace tremolo::coupler
