#include "app/free_field/points_file.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace {

using namespace tremolo::app;
using ::testing::ThrowsMessage;
using tremolo::testing::TemporaryFolder;

TEST(PointsFile, ReadsOnePointALine) {
  const TemporaryFolder folder;
  const auto points = read_points(folder.write("p.csv", "x, y\r\n1.5,-2\r\n\r\n +3e1 , 0\n"), 0.0);
  ASSERT_EQ(points.size(), 2);
  EXPECT_EQ(points[0].x, 1.5);
  EXPECT_EQ(points[0].y, -2.0);
  EXPECT_EQ(points[1].x, 30.0);
  EXPECT_EQ(points[1].y, 0.0);
}

struct Refused {
  const char* text;
  const char* message; ///< after the name of the file
};

class RefusedPoints : public ::testing::TestWithParam<Refused> {};

TEST_P(RefusedPoints, NamesFileLineAndReason) {
  const TemporaryFolder folder;
  const auto file = folder.write("p.csv", GetParam().text);
  EXPECT_THAT([&] { read_points(file, 0.0); },
              ThrowsMessage<std::runtime_error>(file.string() + GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    PointsFile, RefusedPoints,
    ::testing::Values(Refused{"y,x\n0,0\n", ":1: the header must be 'x,y', found 'y,x'"},
                      Refused{"x,y\n0,0\n1,nan\n", ":3: y is 'nan', must be a finite number"},
                      Refused{"x,y\n1e999,0\n", ":2: x is '1e999', must be a finite number"},
                      Refused{"x,y\n1 2,0\n", ":2: x is '1 2', must be a finite number"},
                      Refused{"x,y\n,0\n", ":2: x is '', must be a finite number"},
                      Refused{"x,y\n1,2,3\n", ":2: 2 values x,y are needed, found 3"},
                      Refused{"x,y\n\n1,0.5\n", ":3: y = 0.5 m lies above the free surface at y = 0 m"},
                      Refused{"x,y\n", ": holds no point; a header 'x,y' and one point a line are needed"},
                      Refused{"", ": holds no point; a header 'x,y' and one point a line are needed"}));

TEST(PointsFile, RefusesAFileThatIsNotThere) {
  EXPECT_THAT([] { read_points("/nowhere/p.csv", 0.0); },
              ThrowsMessage<std::runtime_error>("/nowhere/p.csv: there is no such file"));
}

TEST(Times, HoldBothEndsWhereTheStepDividesTheInterval) {
  const auto times = parse_times("0:3:0.02");
  EXPECT_EQ(times.start, 0.0);
  EXPECT_EQ(times.dt, 0.02);
  EXPECT_EQ(times.count, 151);
  EXPECT_EQ(parse_times("0:0.3:0.1").count, 4); // 0.3/0.1 < 3 in binary
  EXPECT_EQ(parse_times("-1:2:0.5").count, 7);
  EXPECT_EQ(parse_times("1:1:5").count, 1);
}

TEST(Times, StopBeforeAnEndThatIsNotReached) {
  EXPECT_EQ(parse_times("0:1:0.3").count, 4);
}

TEST(Times, AreRefusedWithTheReason) {
  const auto refuses = [](const char* text, const char* message) {
    EXPECT_THAT([&] { parse_times(text); }, ThrowsMessage<std::invalid_argument>(message));
  };
  refuses("0:3", "times '0:3': must be T0:T1:DT in s, e.g. 0:3:0.02");
  refuses("0:x:1", "times '0:x:1': 'x' is not a finite number");
  refuses("0:inf:1", "times '0:inf:1': 'inf' is not a finite number");
  refuses("0:3:0", "times '0:3:0': DT is 0 s, must be > 0");
  refuses("3:0:1", "times '3:0:1': T1 = 0 s lies before T0 = 3 s");
  refuses("0:1:1e-9", "times '0:1:1e-9': 1e+09 times, at most 1e+07 are written");
}

TEST(Frequencies, AreAboveZeroAndHoldBothEnds) {
  const auto frequencies = parse_frequencies("0.5:2:0.5");
  EXPECT_THAT(frequencies, ::testing::ElementsAre(0.5, 1.0, 1.5, 2.0));
  EXPECT_THAT(
      [] { parse_frequencies("1:0.5:0.1"); },
      ThrowsMessage<std::invalid_argument>("frequencies '1:0.5:0.1': F1 = 0.5 Hz lies before F0 = 1 Hz"));
}

} // namespace
