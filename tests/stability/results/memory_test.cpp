// A writer's memory does not grow with what it has written.

#include "../../unit/results/sample_run.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

using namespace sample_run;

namespace {

/// Memory of this process that is in use, bytes.
double resident_bytes() {
  double pages = 0.0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

TEST(Memory, OfAWriterIsFlatInTheNumberOfFrames) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "AddressSanitizer keeps what is freed";
#endif
  constexpr std::size_t few = 50;
  constexpr std::size_t many = 1000;
  constexpr double most_growth = 4e6;
  const Folder folder;
  RunWriter run(folder / "run.h5", description);
  TimeSeries& toe = run.add_series("/monitors/toe", monitor_columns, monitor_units);
  run.set_boundary(faces());
  double after_few = 0.0;
  for (std::size_t frame = 0; frame < many; ++frame) {
    const auto exchange = filled(frame, 6, 6);
    toe.append(monitor_row(frame));
    run.append_boundary(frame_time(frame), {exchange, exchange, exchange});
    write_frame(run, frame);
    if (frame + 1 == few) {
      after_few = resident_bytes();
    }
  }
  EXPECT_LT(resident_bytes() - after_few, most_growth);
  run.finish();
  const RunReader reader(folder / "run.h5");
  ASSERT_EQ(reader.frame_times().size(), many);
  EXPECT_EQ(reader.frame_field(many - 1, "stress").values, filled(many - 1, 2, 4 * particles(many - 1)));
}

} // namespace
