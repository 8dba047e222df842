// The rules of monitors, each with a case that keeps it and one that breaks it, and the message.

#include "rule_cases.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Rules, MonitorsLieInSoil) {
  const std::string monitor = "[[monitor]]\nname = \"top\"\npoint = [10.0, 0.0]\n";
  EXPECT_THAT(errors_of(plus(monitor)), IsEmpty());
  EXPECT_THAT(errors_of(plus("[[monitor]]\nname = \"top\"\npoint = [10.0, 0.1]\n")),
              ElementsAre("case.toml:33:9: [[monitor]] 'point' [10, 0.1] lies in no region"));
  EXPECT_THAT(errors_of(plus(monitor + monitor)),
              ElementsAre("case.toml:35:8: [[monitor]] 'name' = \"top\" is taken by the monitor in line 32"));
}

} // namespace
} // namespace tremolo::scene::testing
