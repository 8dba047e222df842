#include "motion/read/read.hpp"
#include "motion/read/write.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

namespace tremolo::motion {
namespace {

const Title title = {"A TITLE", "M 6.7"};

/// Numbers of every size, sign and number of digits.
Record varied() {
  Record record{.unit = Unit::g, .kind = MotionKind::outcrop, .dt = 1.0 / 300.0};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_real_distribution<double> exponent(-12.0, 3.0);
  for (int i = 0; i < 1003; ++i)
    record.samples.push_back(mantissa(random) * std::pow(10.0, exponent(random)));
  record.samples[5] = -1e-140;
  record.samples[6] = 0.0;
  return record;
}

TEST(Writers, PeerRoundTripIsExactToItsEightDigits) {
  const Record record = varied();
  const std::string text = peer_text(record, title);
  std::istringstream stream(text);
  const Record again = parse_record(stream, "x.AT2");
  EXPECT_EQ(again.unit, record.unit);
  EXPECT_EQ(again.kind, record.kind);
  EXPECT_EQ(again.dt, record.dt);
  ASSERT_EQ(again.samples.size(), record.samples.size());
  for (std::size_t i = 0; i < record.samples.size(); ++i)
    ASSERT_NEAR(again.samples[i], record.samples[i], 0.5001e-7 * std::abs(record.samples[i])) << i;
  EXPECT_EQ(peer_text(again, title), text);
}

TEST(Writers, PeerLooksAsPeerDoes) {
  const Record record{.unit = Unit::g, .dt = 0.02, .samples = {0.0, -0.25, 1e-3, 0.5, 1.0, 2.0}};
  EXPECT_EQ(peer_text(record, title),
            "A TITLE\nM 6.7\nACCELERATION TIME SERIES IN UNITS OF G\n"
            "NPTS=      6, DT=  0.0200 SEC\n"
            "  0.0000000E+00 -2.5000000E-01  1.0000000E-03  5.0000000E-01  1.0000000E+00\n"
            "  2.0000000E+00\n");
}

TEST(Writers, CsvRoundTripIsExact) {
  const Record record = varied();
  std::istringstream stream(csv_text(record));
  const Record again = parse_record(stream, "x.csv");
  EXPECT_EQ(again.unit, record.unit);
  EXPECT_EQ(again.kind, record.kind);
  EXPECT_EQ(again.samples, record.samples);
  EXPECT_NEAR(again.dt, record.dt, 1e-15 * record.dt);
}

TEST(Writers, FilesByExtensionInPeersUnits) {
  const testing::TemporaryFolder folder;
  const Record record{.unit = Unit::m_s2, .dt = 0.02, .samples = {0.0, 9.80665, 0.0, 0.0}};
  for (const auto& [name, unit] :
       {std::pair{"a.AT2", Unit::g}, {"a.vt2", Unit::cm_s}, {"a.DT2", Unit::cm}, {"a.csv", Unit::m_s2}}) {
    write_record(record, folder / name, title);
    EXPECT_EQ(read_record(folder / name).unit, unit) << name;
  }
  EXPECT_EQ(read_record(folder / "a.AT2").samples[1], 1.0);
  EXPECT_NEAR(read_record(folder / "a.vt2").samples[2], 2.0 * 9.80665, 1e-6);
  EXPECT_THROW(write_record(record, folder / "a.txt", title), std::invalid_argument);
  EXPECT_THROW(write_record(record, folder / "absent/a.csv", title), std::runtime_error);
}

TEST(Writers, TitlesThatWouldReadAsHeaderAreRefused) {
  const Record record{.dt = 0.02, .samples = {0.0, 1.0}};
  for (const char* line : {"NPTS= 2, DT= 3", "in units of feet", "two\nlines"})
    EXPECT_THROW(peer_text(record, {line, ""}), std::invalid_argument) << line;
}

} // namespace
} // namespace tremolo::motion
