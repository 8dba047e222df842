// The line that a run shows of itself while it goes on.

#include "app/run/run_display.hpp"

#include <gtest/gtest.h>

namespace tremolo::app {
namespace {

TEST(ProgressText, SaysHowFarAStageIs) {
  EXPECT_EQ(progress_text({.stage = "gravity", .step = 1200, .residual = 3.24e-5}, 1200, 0.0, 2.0),
            "gravity: step 1200, residual 3.2e-05, 600 steps/s");
  EXPECT_EQ(progress_text({.stage = "shaking", .step = 300, .time = 1.5, .end_time = 6.0}, 300, 1.5, 3.0),
            "shaking: step 300, simulated 1.50 of 6.00 s, 100 steps/s, 9 s left");
}

} // namespace
} // namespace tremolo::app
