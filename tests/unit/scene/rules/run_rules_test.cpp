// The rules of monitors, each with a case that keeps it and one that breaks it, and the message.

#include "rule_cases.hpp"

#include <gmock/gmock.h>

#include <sys/resource.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Rules, MonitorsLieInSoil) {
  const std::string monitor = "[[monitor]]\nname = \"top\"\npoint = [10.0, 0.0]\n";
  EXPECT_THAT(errors_of(plus(monitor)), IsEmpty());
  EXPECT_THAT(errors_of(plus("[[monitor]]\nname = \"top\"\npoint = [10.0, 0.1]\n")),
              ElementsAre("case.toml:33:9: [[monitor]] 'point' [10, 0.1] lies in no region"));
  EXPECT_THAT(errors_of(plus(monitor + monitor)),
              ElementsAre("case.toml:35:8: [[monitor]] 'name' = \"top\" is taken by the monitor in line 32"));
}

TEST(Rules, MonitorsHavePlainNames) {
  const auto named = [](const char* name) {
    return errors_of(plus(std::string("[[monitor]]\nname = \"") + name + "\"\npoint = [10.0, 0.0]\n"));
  };
  for (const char* good : {"crest", "P 1.5", "böschung_2", "a-b+c"})
    EXPECT_THAT(named(good), IsEmpty()) << good;
  for (const char* bad : {"../../x/y", ".", "a/b", "-o", "$HOME"})
    EXPECT_THAT(named(bad), ElementsAre(HasSubstr("letters, digits, blanks and _ - + . are allowed"))) << bad;
}

TEST(Rules, MonitorsTellTheParticleThatTheyFollow) {
  // Two particles a cell and direction: 0.25 m and 0.75 m from the edges of cells of 1 m.
  const auto monitor = [](const char* point) {
    return remarks_of(plus(std::string("[[monitor]]\nname = \"m\"\npoint = ") + point + "\n"));
  };
  EXPECT_THAT(
      monitor("[10.0, 0.0]"),
      Contains(HasSubstr("note: [[monitor]] monitor \"m\" follows the particle that starts at [9.75, -0.25], "
                         "0.354 m from its point")));
  EXPECT_THAT(monitor("[10.25, -0.25]"), Not(Contains(HasSubstr("follows the particle"))));
  // In finer cells.
  EXPECT_THAT(remarks_of(plus("[[refine]]\nbox = [8.0, -2.0, 12.0, 0.0]\nlevel = 2\n"
                              "[[monitor]]\nname = \"m\"\npoint = [10.0, 0.0]\n")),
              Contains(HasSubstr("starts at [9.9375, -0.0625], 0.0884 m from its point")));
}

/// The mesh has 8e8 particles: only those around the point are looked at.
TEST(Rules, MonitorsOfHugeMeshesTakeLittleMemory) {
  const auto peak = [] {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return use.ru_maxrss; // KiB
  };
  const auto before = peak();
  EXPECT_THAT(remarks_of(with("size = 1.0", "size = 0.001",
                              plus("[[monitor]]\nname = \"m\"\npoint = [10.0, 0.0]\n"))),
              Contains(HasSubstr("starts at [9.99975, -0.00025]")));
  EXPECT_LT(peak() - before, 100'000);
}

} // namespace
} // namespace tremolo::scene::testing
