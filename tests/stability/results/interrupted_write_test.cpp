// Every single write of a run is made the last one, twice: once because the process dies before it, once
// because the disk is full from there on. This program's own pwrite and ftruncate stand in front of the C
// library's.

#include "../../unit/results/sample_run.hpp"

#include <gtest/gtest.h>

#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <fstream>

using namespace tremolo::results;
using namespace sample_run;

namespace {

enum class Fault { none, death, full_disk };

constexpr int death_status = 9;

struct Interruption {
  Fault fault = Fault::none;
  int writes_left = 0;
  int writes_seen = 0;

  /// True where the call shall fail.
  bool strikes() {
    ++writes_seen;
    if (fault == Fault::none || writes_left-- > 0) {
      return false;
    }
    if (fault == Fault::death) {
      ::_exit(death_status);
    }
    return true;
  }
};

Interruption interruption; // set in the forked child only

ssize_t interrupted_pwrite(int descriptor, const void* data, size_t size, off_t offset, off_t file_end) {
  // A full disk still lets a file's existing blocks be overwritten.
  const bool grows = offset + static_cast<off_t>(size) > file_end;
  if ((interruption.fault != Fault::full_disk || grows) && interruption.strikes()) {
    errno = ENOSPC;
    return -1;
  }
  return ::syscall(SYS_pwrite64, descriptor, data, size, offset);
}

} // namespace

extern "C" ssize_t pwrite(int descriptor, const void* data, size_t size, off_t offset) {
  return interrupted_pwrite(descriptor, data, size, offset, ::lseek(descriptor, 0, SEEK_END));
}

extern "C" int ftruncate(int descriptor, off_t size) noexcept {
  if (interruption.fault == Fault::death) {
    interruption.strikes();
  }
  return static_cast<int>(::syscall(SYS_ftruncate, descriptor, size));
}

namespace {

/// Writes a frame in pieces, with nodes of contact beside it.
void write_streamed_frame(RunWriter& run, std::size_t frame) {
  const auto streamed = [&](std::string_view name, std::size_t field) {
    return StreamedField{name, "1", 2, false, [=](const auto& take) {
                           const auto values = filled(frame, field, 2 * particles(frame));
                           take(std::span(values).first(2));
                           take(std::span(values).subspan(2));
                         }};
  };
  const auto nodes = filled(frame, 2, 2);
  const std::vector<Field> contact{{"position", "m", 2, nodes}};
  run.write_frame(frame_time(frame), particles(frame), {streamed("position", 0), streamed("velocity", 1)},
                  std::vector<FramePart>{{"contact", contact}});
}

/// Writes a run, noting each finished frame beside it.
void write_steps(RunWriter& run, std::size_t frames, std::ofstream& flushed) {
  TimeSeries& toe = run.add_series("/monitors/toe", monitor_columns, monitor_units);
  run.set_boundary(faces());
  run.flush();
  flushed << 'o' << std::flush;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (std::size_t row = 0; row < 300; ++row) { // so that the series needs a new chunk now and then
      toe.append(monitor_row(300 * frame + row));
    }
    const auto vectors = filled(frame, 6, 6);
    run.append_boundary(frame_time(frame), {vectors, vectors, vectors});
    write_streamed_frame(run, frame);
    flushed << '.' << std::flush;
  }
  run.table("/timings", {{{"pass", "", std::vector<std::string>{"p2g"}}}});
  flushed << 't' << std::flush;
  run.finish();
}

/// As the domain does it: a failure is written into the file, if it still can be.
void write_run(const std::filesystem::path& file, std::size_t frames, const std::filesystem::path& log) {
  std::ofstream flushed(log);
  RunWriter run(file, description);
  try {
    write_steps(run, frames, flushed);
  } catch (const std::runtime_error& error) {
    run.abort(error.what());
    throw;
  }
}

void expect_all_that_was_flushed(const std::filesystem::path& file, const std::string& log) {
  const std::size_t frames = static_cast<std::size_t>(std::ranges::count(log, '.'));
  const RunReader run(file);
  EXPECT_TRUE(run.status() == "running" || run.status() == "complete") << run.status();
  EXPECT_EQ(run.case_text(), description.case_text);
  ASSERT_GE(run.frame_times().size(), frames);
  ASSERT_LE(run.frame_times().size(), frames + 1);
  for (std::size_t frame = 0; frame < run.frame_times().size(); ++frame) {
    ASSERT_EQ(run.frame_times()[frame], frame_time(frame));
    ASSERT_EQ(run.frame_field(frame, "velocity").values, filled(frame, 1, 2 * particles(frame)));
    ASSERT_EQ(run.part_field("contact", frame, "position").values, filled(frame, 2, 2));
  }
  const SeriesData toe = run.series("/monitors/toe");
  ASSERT_GE(toe.rows(), 300 * frames);
  for (std::size_t row = 0; row < toe.rows(); ++row) {
    ASSERT_EQ(toe.values[9 * row], monitor_row(row)[0]) << "row " << row;
  }
  if (log.find('t') != std::string::npos) {
    EXPECT_TRUE(run.has_table("/timings"));
  }
}

int writes_of_whole_run(std::size_t frames) {
  const Folder folder;
  interruption = {};
  write_run(folder / "run.h5", frames, folder / "log");
  return interruption.writes_seen;
}

/// Runs the writer in a child with a fault at its write number `write`; true where the fault struck.
bool check_interrupted_at(Fault fault, int write, std::size_t frames) {
  const Folder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    interruption = {fault, write, 0};
    try {
      write_run(folder / "run.h5", frames, folder / "log");
    } catch (const std::runtime_error& error) {
      const bool told = std::string(error.what()).find("No space left on device") != std::string::npos;
      ::_exit(told ? death_status : 1);
    } catch (...) {
      ::_exit(2);
    }
    ::_exit(0);
  }
  int state = 0;
  ::waitpid(child, &state, 0);
  EXPECT_TRUE(WIFEXITED(state));
  EXPECT_TRUE(WEXITSTATUS(state) == 0 || WEXITSTATUS(state) == death_status) << WEXITSTATUS(state);
  std::ifstream in(folder / "log");
  const std::string log{std::istreambuf_iterator<char>(in), {}};
  if (!log.empty()) {
    expect_all_that_was_flushed(folder / "run.h5", log);
  } else if (std::filesystem::exists(folder / "run.h5")) {
    EXPECT_EQ(RunReader(folder / "run.h5").status(), "running");
  }
  return WEXITSTATUS(state) == death_status;
}

void check_every_write(Fault fault, std::size_t frames) {
  const int writes = writes_of_whole_run(frames);
  ASSERT_GT(writes, static_cast<int>(5 * frames)) << "the interception of writes does not work";
  int struck = 0;
  for (int write = 0; write < writes; ++write) {
    SCOPED_TRACE("interrupted at write " + std::to_string(write) + " of " + std::to_string(writes));
    struck += check_interrupted_at(fault, write, frames) ? 1 : 0;
    if (testing::Test::HasFailure()) {
      return;
    }
  }
  EXPECT_GT(struck, static_cast<int>(frames));
}

TEST(InterruptedWrite, DeathBeforeAnyWriteLosesNothingFlushed) {
  check_every_write(Fault::death, 5);
}

TEST(InterruptedWrite, FullDiskAtAnyWriteLosesNothingFlushed) {
  check_every_write(Fault::full_disk, 5);
}

} // namespace
