#include "motion/read/read.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

namespace tremolo::motion {
namespace {

Record parsed(const std::string& text, const std::string& file, const ReadAs& as = {}) {
  std::istringstream stream(text);
  return parse_record(stream, file, as);
}

std::string error_of(const std::string& text, const std::string& file, const ReadAs& as = {}) {
  try {
    parsed(text, file, as);
  } catch (const RecordError& error) {
    return error.what();
  }
  return "";
}

std::string peer(const char* units, const char* header = "NPTS= 2, DT= .01") {
  return fmt::format("TITLE M 6.7, 20 m deep\n{}\n{}\n .1E+00 -.2\n", units, header);
}

TEST(Peer, HeadersInAnySpelling) {
  for (const char* header :
       {"NPTS=   4, DT=   .0200 SEC   ", "4    0.0200    NPTS, DT", "npts = 4 , dt = 0.02", "NPTS=4,DT=.02D0",
        "0.0200 4 DT, NPTS", "NPTS= 4, DT= .02000 SEC\r"}) {
    const auto record = parsed(
        fmt::format("A TITLE OF 1994\nACCELERATION IN UNITS OF G\n{}\n .1E-01 -.2 0.3\n +4.D-1\n", header),
        "x");
    EXPECT_DOUBLE_EQ(record.dt, 0.02) << header;
    EXPECT_EQ(record.unit, Unit::g);
    ASSERT_EQ(record.samples.size(), 4U) << header;
    EXPECT_DOUBLE_EQ(record.samples[1], -0.2) << header;
    EXPECT_DOUBLE_EQ(record.samples[3], 0.4) << header;
  }
}

TEST(Peer, UnitsFromNameAndHeader) {
  EXPECT_EQ(parsed(peer("no word"), "x.AT2").unit, Unit::g);
  EXPECT_EQ(parsed(peer("no word"), "x.vt2").unit, Unit::cm_s);
  EXPECT_EQ(parsed(peer("no word"), "x.DT2").unit, Unit::cm);
  EXPECT_EQ(parsed(peer("The units are (g)"), "x.AT2").unit, Unit::g);
  EXPECT_EQ(parsed(peer("ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz"), "x.txt").unit,
            Unit::g);
  EXPECT_EQ(parsed(peer("ACCELERATION IN UNITS OF CM/SEC/SEC"), "x.AT2").unit, Unit::cm_s2);
  EXPECT_EQ(parsed(peer("VELOCITY TIME SERIES IN UNITS OF CM/S"), "x.txt").unit, Unit::cm_s);
  const auto record = parsed(peer("DISPLACEMENT TIME SERIES IN UNITS OF CM, OUTCROP"), "x.txt");
  EXPECT_EQ(record.unit, Unit::cm);
  EXPECT_EQ(record.kind, MotionKind::outcrop);
}

TEST(Peer, WhatIsLeftOpenIsAskedFor) {
  EXPECT_EQ(
      error_of(peer("no word"), "x.txt"),
      "x.txt:3: neither name nor header says whether this is acceleration, velocity or displacement: say "
      "which (--quantity or --unit)");
  EXPECT_EQ(parsed(peer("no word"), "x.txt", {.quantity = Quantity::velocity}).unit, Unit::cm_s);
  EXPECT_EQ(parsed(peer("no word"), "x.txt", {.unit = Unit::m_s2}).unit, Unit::m_s2);
  EXPECT_EQ(error_of(peer("VELOCITY IN UNITS OF CM/S"), "x.AT2"),
            "x.AT2:3: the name says acceleration, the header velocity: say which (--quantity)");
  EXPECT_EQ(parsed(peer("VELOCITY IN UNITS OF CM/S"), "x.AT2", {.quantity = Quantity::velocity}).unit,
            Unit::cm_s);
  EXPECT_EQ(error_of(peer("ACCELERATION IN UNITS OF G"), "x.AT2", {.quantity = Quantity::velocity}),
            "x.AT2:3: the file holds acceleration, not velocity");
  EXPECT_EQ(
      error_of(peer("ACCELERATION IN UNITS OF FURLONG"), "x.AT2"),
      "x.AT2:3: 'UNITS OF FURLONG' is not wholly understood as a unit: say which (--unit), and a factor by "
      "--scale");
  EXPECT_EQ(error_of(peer("x"), "x.AT2", {.quantity = Quantity::acceleration, .unit = Unit::cm}),
            "x.AT2:3: cm is not a unit of acceleration");
}

TEST(Peer, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(error_of("title\n0.1 0.2\n", "x.AT2"), "x.AT2:2: no header line with NPTS and DT");
  EXPECT_EQ(error_of("NPTS= 2\n0.1 0.2\n", "x.AT2"), "x.AT2:2: no header line with NPTS and DT");
  EXPECT_EQ(error_of("NPTS= 2, DT= .01\n0.1\nabc\n", "x.AT2"), "x.AT2:3: 'abc' is not a finite number");
  EXPECT_EQ(error_of("NPTS= 2, DT= .01\n0.1 nan\n", "x.AT2"), "x.AT2:2: 'nan' is not a finite number");
  EXPECT_EQ(error_of("NPTS= 3, DT= .01\n0.1 0.2\n", "x.AT2"),
            "x.AT2:2: the header says NPTS = 3 but there are 2 samples");
  EXPECT_EQ(error_of("NPTS= 2, DT= .01\n0.1 0.2\n0.3\n", "x.AT2"),
            "x.AT2:3: the header says NPTS = 2 but there are more samples");
  EXPECT_EQ(error_of("NPTS= 3, DT= 0\n0.1 0.2 0.3\n", "x.AT2"), "x.AT2:1: DT = 0 s, must be > 0");
  EXPECT_EQ(error_of("NPTS= 1, DT= .01\n0.1\n", "x.AT2"),
            "x.AT2:1: NPTS = 1, must be a whole number from 2 to 2e+07");
  EXPECT_EQ(error_of("", "x.AT2"), "x.AT2:1: no header line with NPTS and DT");
  EXPECT_EQ(error_of(std::string("a\nb\0c\n", 6), "x.AT2"), "x.AT2:2: binary data, not text");
  EXPECT_EQ(error_of("a\n" + std::string(longest_line + 1, '1'), "x.AT2"),
            "x.AT2:2: a line of more than 65536 characters");
}

/// An endless line that counts what is taken from it.
class Endless : public std::streambuf {
public:
  std::size_t given = 0;

protected:
  int_type underflow() override {
    block_.fill('7');
    given += block_.size();
    setg(block_.data(), block_.data(), block_.data() + block_.size());
    return traits_type::to_int_type(block_[0]);
  }

private:
  std::array<char, 1024> block_{};
};

TEST(Peer, AnEndlessLineIsRefusedBeforeItIsAllRead) {
  for (const char* file : {"x.AT2", "x.csv"}) {
    Endless endless;
    std::istream stream(&endless);
    EXPECT_THROW(parse_record(stream, file), RecordError);
    EXPECT_LE(endless.given, longest_line + 2048);
  }
}

TEST(Table, TwoColumnsWithAndWithoutHeader) {
  const auto record = parsed("time (s), acceleration (cm/s/s) outcrop\n0,1\n0.005,2\n0.01,-3\n", "x.csv");
  EXPECT_EQ(record.unit, Unit::cm_s2);
  EXPECT_EQ(record.kind, MotionKind::outcrop);
  EXPECT_EQ(record.dt, 0.005);
  EXPECT_EQ(record.samples, (std::vector{1.0, 2.0, -3.0}));
  EXPECT_EQ(parsed("# t,acc_g outcrop; soil 20 m gamma=20 kN/m3\n0 1\n.1 2\n", "x.csv").unit, Unit::g);
  EXPECT_EQ(parsed("# made in 1994\n# t;v_cm_s\n0;1\n.1;2\n", "x.csv").unit, Unit::cm_s);
  EXPECT_EQ(parsed("0.0 \t -0.0\n0.001 \t 2\n", "inputp1", {.unit = Unit::m_s}).dt, 0.001);
  EXPECT_EQ(parsed("t,v\n0,1\n.1,2\n", "x.csv", {.unit = Unit::mm}).unit, Unit::mm);
}

TEST(Table, RoundedTimesGiveTheStepThatIsMeant) {
  std::string text = "t,u (m)\n";
  for (int i = 0; i < 1000; ++i)
    text += fmt::format("{:.3f},0\n", i * 0.025);
  EXPECT_EQ(parsed(text, "x.csv").dt, 0.025);
}

TEST(Table, SaysWhatIsWrongAndWhere) {
  const std::string head = "t,a (g)\n";
  EXPECT_EQ(error_of(head + "0,1\n.1\n", "x.csv"), "x.csv:3: a time and a value are needed, found 1 columns");
  EXPECT_EQ(error_of(head + "0,1,2\n", "x.csv"), "x.csv:2: a time and a value are needed, found 3 columns: "
                                                 "say which holds the motion (--column): 2 to 3");
  EXPECT_EQ(error_of(head + "0,1\n.1,inf\n", "x.csv"), "x.csv:3: 'inf' is not a finite number");
  EXPECT_EQ(error_of(head + "0,1\n.1,2\n.1,3\n", "x.csv"), "x.csv:4: time 0.1 s does not come after 0.1 s");
  EXPECT_EQ(error_of(head + "0,1\n.1,2\n.4,3\n", "x.csv"),
            "x.csv:3: time 0.1 s, expected 0.2 s: the steps must be equal, 0.2 s on average here");
  EXPECT_EQ(error_of(head + ".1,1\n.2,2\n", "x.csv"),
            "x.csv:2: the first time is 0.1 s, must be 0; a spectrum is no motion");
  EXPECT_EQ(error_of(head + "0,1\n", "x.csv"), "x.csv:2: 1 samples, at least 2 are needed");
  EXPECT_EQ(
      error_of("0,1\n.1,2\n", "x.csv"),
      "x.csv:1: neither name nor header says whether this is acceleration, velocity or displacement: say "
      "which (--quantity or --unit)");
  EXPECT_EQ(error_of("t,velocity\n0,1\n.1,2\n", "x.csv"),
            "x.csv:1: the header does not name the unit of the velocity: say which (--unit)");
}

std::string refusal_of(const std::string& text, const char* name) {
  std::istringstream stream(text);
  try {
    parse_record(stream, name);
  } catch (const RecordError& error) {
    return error.what();
  }
  return "";
}

TEST(Peer, StepsThatNoMotionHasAreRefused) {
  for (const char* dt : {"1e-12", "1e-8", "100"})
    EXPECT_NE(refusal_of(std::string("NPTS= 3, DT= ") + dt + " SEC\n0.0 0.1 0.0\n", "x.AT2")
                  .find("must be from 1e-05 to 10 s"),
              std::string::npos)
        << dt;
  EXPECT_EQ(refusal_of("NPTS= 3, DT= 1e-4 SEC\n0.0 0.1 0.0\n", "x.AT2"), "");
}

TEST(Peer, DecimalCommasAreNamed) {
  EXPECT_EQ(refusal_of("NPTS= 3, DT= .01 SEC\n0,001 -0,102 1,5E-2\n", "x.AT2"),
            "x.AT2:2: decimal commas: numbers are written with a point, 0.123 instead of 0,123");
  EXPECT_EQ(refusal_of("NPTS= 3, DT= 1,02 SEC\n0.001 -0.102 1.5E-2\n", "x.AT2"),
            "x.AT2:1: decimal commas: numbers are written with a point, 0.123 instead of 0,123");
  // A comma in front of digits and behind nothing: read past it, ,005 s are 5 s.
  for (const char* header : {"NPTS= 3, DT= ,005 SEC", "NPTS= 3, DT=,005 SEC", "3 ,005 NPTS, DT"})
    EXPECT_EQ(refusal_of(fmt::format("{}\n0.001 -0.102 1.5E-2\n", header), "x.AT2"),
              "x.AT2:1: decimal commas: numbers are written with a point, 0.123 instead of 0,123")
        << header;
  EXPECT_EQ(refusal_of("NPTS= 3, DT= .01 SEC\n,001 -,102 1,5E-2\n", "x.AT2"),
            "x.AT2:2: decimal commas: numbers are written with a point, 0.123 instead of 0,123");
  EXPECT_EQ(refusal_of("NPTS= 3,DT= .01 SEC\n0.001 -0.102 1.5E-2\n", "x.AT2"), "");
  EXPECT_EQ(refusal_of("NPTS= 3, DT= .01 SEC\n0.001,-0.102,1.5E-2\n", "x.AT2"), "");
}

TEST(Files, AreRefusedInOneLine) {
  const testing::TemporaryFolder folder;
  const auto error_of_file = [](const std::filesystem::path& file) {
    try {
      read_record(file);
    } catch (const RecordError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
    return std::string();
  };
  EXPECT_EQ(error_of_file(folder / "absent.AT2"), ": there is no such file");
  EXPECT_EQ(error_of_file(folder / "."), ": cannot be read: this is a folder; give the file in it");
  EXPECT_EQ(error_of_file(folder.write("e.AT2", "")), ":1: no header line with NPTS and DT");
  EXPECT_EQ(error_of_file(folder.write("e.csv", "")), ":1: 0 samples, at least 2 are needed");
  EXPECT_EQ(error_of_file(folder.write("j.h5", "\x89HDF\r\n\x1a\njunk")),
            ": looks like HDF5 but cannot be opened: damaged, or in use");
  const std::string advice =
      ": binary data, which are not read; write the samples as text, a line each of time "
      "and value below a header that names the unit";
  for (const std::string& version : {std::string("\6\0\0\0", 4), std::string("\0\0\0\6", 4)})
    EXPECT_EQ(error_of_file(folder.write("a.sac", std::string(304, 'x') + version + std::string(400, 'x'))),
              ": SAC" + advice);
  EXPECT_EQ(error_of_file(folder.write("a.mseed", "000001D STA  00BHZNN" + std::string(492, '\0'))),
            ": miniSEED" + advice);
  EXPECT_EQ(error_of_file(folder.write("b.mseed", "MS\3" + std::string(60, '\0'))), ": miniSEED" + advice);
  EXPECT_EQ(error_of_file(folder.write("short", "123456")),
            ":1: a time and a value are needed, found 1 columns");
}

} // namespace
} // namespace tremolo::motion
