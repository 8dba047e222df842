#include "motion/read/read_spectrum.hpp"
#include "motion/record.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>
#include <string>

namespace tremolo::motion {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TargetSpectrum parsed(const std::string& text) {
  std::istringstream stream(text);
  return parse_spectrum(stream, "target.csv");
}

std::string refusal(const std::string& text) {
  try {
    parsed(text);
  } catch (const RecordError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SpectrumTable, TakesItsColumnsByName) {
  const auto si = parsed("period,displacement,acceleration\n0.1,7,1.5\n0.2,8,2.5\n");
  EXPECT_THAT(si.periods, ElementsAre(0.1, 0.2));
  EXPECT_THAT(si.acceleration, ElementsAre(1.5, 2.5));
  EXPECT_THAT(parsed("# acceleration_g; period\n0.5; 0.1\n\n1; 0.2\n").acceleration,
              ElementsAre(0.5 * standard_gravity, standard_gravity));
}

TEST(SpectrumTable, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(refusal("0.1,1.5\n0.2,2.5\n"),
              HasSubstr("target.csv:1: the header of a target spectrum names"));
  EXPECT_THAT(refusal("period,acceleration\n0.1,1\n0.1,2\n"),
              HasSubstr("target.csv:3: period 0.1 s, must be > 0 and above that of the row before"));
  EXPECT_THAT(refusal("period,acceleration\n0.1,-1\n"),
              HasSubstr("target.csv:2: acceleration -1, must be > 0"));
  EXPECT_THAT(refusal("period,acceleration\n0.1,nan\n"), HasSubstr("'nan' is not a finite number"));
  EXPECT_THAT(refusal("period,acceleration\n0.1,1,3\n"), HasSubstr("3 columns, the header has 2"));
  EXPECT_THAT(refusal("period,acceleration\n0.1,1\n"), HasSubstr("needs at least two periods"));
}

TEST(SpectrumTable, IsLinearOnLogarithmicAxes) {
  const auto target = parsed("period,acceleration\n0.1,1\n1,100\n");
  EXPECT_NEAR(target.at(0.1), 1.0, 1e-12);
  EXPECT_NEAR(target.at(std::sqrt(0.1)), 10.0, 1e-10);
  EXPECT_NEAR(target.at(1.0), 100.0, 1e-10);
}

} // namespace
} // namespace tremolo::motion
