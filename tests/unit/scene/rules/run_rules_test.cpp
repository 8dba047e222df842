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

TEST(Rules, LinesLieInSoil) {
  const auto line = [](const char* keys) {
    return errors_of(plus(std::string("[[line]]\nname = \"shaft\"\n") + keys));
  };
  EXPECT_THAT(line("from = [10.0, 0.0]\nto = [10.0, -10.0]\n"), IsEmpty());
  EXPECT_THAT(
      line("from = [10.0, 1.5]\nto = [10.0, -10.0]\n"),
      ElementsAre(
          "case.toml:33:8: [[line]] the line leaves the soil: its point [10, 1.5] lies in no region"));
  EXPECT_THAT(line("from = [10.0, 0.0]\nto = [10.0, 0.0]\n"),
              ElementsAre("case.toml:34:6: [[line]] 'to' [10, 0] is 'from': the line has no length"));
  EXPECT_THAT(
      line("from = [10.0, 0.0]\nto = [10.0, -10.0]\nspacing = 0.1\n"),
      ElementsAre(
          "case.toml:35:11: [[line]] points every 0.1 m along 10 m are more than 100: 'spacing' must be at "
          "least 0.101 m, or make several lines of it"));
  EXPECT_THAT(line("from = [10.0, 0.0]\nto = [10.0, -10.0]\nspacing = 0.0\n"),
              ElementsAre(HasSubstr("'spacing'")));
  EXPECT_THAT(line("from = [10.0, 0.0]\nto = [10.0, -10.0]\n[[line]]\nname = \"shaft\"\nfrom = [5.0, 0.0]\n"
                   "to = [5.0, -1.0]\n"),
              ElementsAre(HasSubstr("'name' = \"shaft\" is taken by the line in line 32")));
}

TEST(Rules, LinesAvoidStructures) {
  const std::string block =
      "[[structure]]\nname = \"block\"\npolygon = [[8.0, -4.0], [12.0, -4.0], [12.0, 1.0], [8.0, "
      "1.0]]\ndensity = 2000.0\nrigid = true\nfriction = 0.5\n[[stage]]\nkind = \"gravity\"\n";
  EXPECT_THAT(errors_of(plus(block + "[[line]]\nname = \"l\"\nfrom = [10.0, -9.0]\nto = [10.0, 0.0]\n")),
              Contains(HasSubstr("the line crosses structure 'block' at [10, -3], where no soil is")));
}

TEST(Rules, SlidingMassesHoldSoil) {
  const auto mass = [](const char* outline) {
    return errors_of(plus(std::string("[[sliding_mass]]\nname = \"wedge\"\n") + outline + "\n"));
  };
  EXPECT_THAT(mass("circle = { centre = [10.0, 5.0], radius = 8.0 }"), IsEmpty());
  EXPECT_THAT(mass("polygon = [[5.0, -3.0], [15.0, -3.0], [15.0, 9.0], [5.0, 9.0]]"), IsEmpty());
  EXPECT_THAT(mass("circle = { centre = [10.0, 5.0], radius = 5.0 }"),
              ElementsAre(HasSubstr("'circle' holds no particle of soil at the start")));
  EXPECT_THAT(mass("polygon = [[5.0, -3.0], [15.0, 0.0], [15.0, -3.0], [5.0, 0.0]]"),
              ElementsAre(HasSubstr("'polygon' crosses or touches itself")));
  EXPECT_THAT(mass(""),
              ElementsAre(HasSubstr("missing 'polygon' or 'circle': what encloses the sliding mass")));
  EXPECT_THAT(mass("polygon = [[5.0, -3.0], [15.0, -3.0], [15.0, 0.0]]\ncircle = { centre = [10.0, 0.0], "
                   "radius = 5.0 }"),
              ElementsAre(HasSubstr("'polygon' and 'circle' exclude each other")));
}

TEST(Rules, MonitorsLieOnParticles) {
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
