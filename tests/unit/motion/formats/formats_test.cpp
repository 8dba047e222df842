// The formats of networks, in files that the test makes: what is read is what was written, and what the file
// says of itself.

#include "motion/read/read.hpp"
#include "tests/support/network_texts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace tremolo::motion {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using tremolo::testing::network_samples;
using tremolo::testing::network_texts;
using tremolo::testing::NetworkText;

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

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// Samples in cm/s2 within what the printed digits keep.
void expect_samples(const Record& record, double factor, const std::string& name) {
  const Record in_gal = with_unit(record, Unit::cm_s2);
  EXPECT_EQ(record.dt, tremolo::testing::network_step) << name;
  ASSERT_EQ(in_gal.samples.size(), network_samples().size()) << name;
  constexpr double digits = 0.006; // of g/10 with four decimals, the coarsest
  for (std::size_t i = 0; i < in_gal.samples.size(); ++i)
    EXPECT_NEAR(in_gal.samples[i], factor * network_samples()[i], digits) << name << " " << i;
  EXPECT_THAT(record.origin.doubts, IsEmpty()) << name;
}

TEST(Networks, EachComponentByNumberAndName) {
  for (const NetworkText& file : network_texts())
    for (std::size_t i = 0; i < file.components.size(); ++i)
      for (const std::string& asked : {fmt::format("{}", i + 1), file.components[i]}) {
        SCOPED_TRACE(fmt::format("{} --component {}", file.format, asked));
        const Record record = parsed(file.text, file.file, {.component = asked});
        expect_samples(record, static_cast<double>(i + 1), file.format);
        EXPECT_EQ(record.origin.format, file.format);
        EXPECT_EQ(record.origin.components, file.components.size());
        EXPECT_THAT(record.origin.component, HasSubstr(file.components[i]));
        EXPECT_THAT(record.origin.unit, HasSubstr("as the file says"));
      }
}

TEST(Networks, SeveralComponentsAreNamedWhereNoneIsChosen) {
  for (const NetworkText& file : network_texts()) {
    const std::string error = error_of(file.text, file.file);
    if (file.components.size() == 1) {
      EXPECT_EQ(error, "") << file.format;
      continue;
    }
    EXPECT_THAT(error, HasSubstr("holds 3 components: say which (--component)")) << file.format;
    for (const std::string& component : file.components)
      EXPECT_THAT(error, HasSubstr(component)) << file.format;
    EXPECT_THAT(error_of(file.text, file.file, {.component = "7"}),
                HasSubstr("'7' is none of its components"));
    EXPECT_THAT(error_of(file.text, file.file, {.column = "2"}), HasSubstr("--component chooses"));
  }
}

TEST(Networks, TheQuantityIsChosenWhereAComponentHasSeveral) {
  const std::string csmip = tremolo::testing::csmip_text();
  const Record velocity = parsed(csmip, "x.V2", {.quantity = Quantity::velocity, .component = "2"});
  EXPECT_EQ(velocity.unit, Unit::cm_s);
  EXPECT_NEAR(velocity.samples[2], -0.6, 1e-7);
  EXPECT_THAT(velocity.origin.doubts, IsEmpty());
  const Record displacement = parsed(tremolo::testing::geonet_text(), "x.V2A",
                                     {.quantity = Quantity::displacement, .component = "1"});
  EXPECT_EQ(displacement.unit, Unit::mm);
  EXPECT_NEAR(displacement.samples[2], -0.3, 1e-3);
}

TEST(Networks, ALineWithCarriageReturnsIsTheSame) {
  for (const NetworkText& file : network_texts()) {
    std::string text;
    for (const char c : file.text)
      text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    expect_samples(parsed(text, file.file, {.component = "1"}), 1.0, file.format);
  }
}

TEST(Networks, APeakThatTheSamplesDoNotHaveIsReported) {
  const std::string csmip =
      replaced(tremolo::testing::csmip_text(), "  -3.000    CM/SEC/SEC", " -30.000    CM/SEC/SEC");
  EXPECT_THAT(parsed(csmip, "x.V2", {.component = "1"}).origin.doubts,
              ::testing::ElementsAre("the file states a peak of 30 cm/s2, its samples have 3"));
  const std::string knet = replaced(tremolo::testing::knet_text(), "2000(gal)/4000", "2000(gal)/400");
  EXPECT_THAT(parsed(knet, "x.EW").origin.doubts,
              ::testing::ElementsAre("the file states a peak of 3 cm/s2, its samples have 30"));
}

TEST(Networks, ChannelsOfOneNameHaveNumbers) {
  std::string text = tremolo::testing::csmip_text();
  for (const char* name : {"CHAN  2:  90 DEG\n", "CHAN  3:  135 DEG\n"})
    text = replaced(text, name, "CHAN  1:  45 DEG\n");
  EXPECT_THAT(error_of(text, "x.V2"),
              HasSubstr("1 'CHAN 1: 45 DEG', 2 'CHAN 1: 45 DEG (2)', 3 'CHAN 1: 45 DEG (3)'"));
  expect_samples(parsed(text, "x.V2", {.component = "3"}), 3.0, "third");
}

TEST(Networks, PointsBeyondTheirNumberAreNotPassedOver) {
  const std::string text =
      replaced(tremolo::testing::csmip_text(), " 12 POINTS OF ACCEL", " 8 POINTS OF ACCEL");
  EXPECT_THAT(error_of(text, "x.V2", {.component = "1"}), HasSubstr("stands behind the points"));
}

TEST(Networks, WhatCannotBecomeAMotionIsNamed) {
  EXPECT_EQ(error_of("Response and Fourier amplitude spectra (78 periods)\nCorrected accelerogram\n", "x.V3"),
            "x.V3: CSMIP volume 3: response spectra, not a motion; take volume 2 (.V2) of the same record");
  EXPECT_THAT(error_of("Uncorrected accelerogram 2016 GNS Science\nSite WTMC 42\n", "x.V1A"),
              HasSubstr("V2A"));
  EXPECT_THAT(
      error_of(replaced(tremolo::testing::cosmos_text(), "units=cm/sec2(04)", "units=counts(50)"), "x.V1"),
      HasSubstr("raw counts of the instrument"));
}

TEST(Networks, FilesThatEndEarlyOrGoOnAreRefused) {
  for (const NetworkText& file : network_texts()) {
    const std::string cut = file.text.substr(0, file.text.size() - file.text.size() / 20);
    const std::string_view format = file.format;
    if (format == "K-NET, KiK-net") { // states its number of samples by a duration alone
      EXPECT_THAT(parsed(cut, file.file).origin.doubts,
                  Contains(HasSubstr("but the header says a duration")));
      continue;
    }
    EXPECT_NE(error_of(cut, file.file, {.component = "1"}), "") << file.format;
    if (format == "CSMIP") // text may follow its channels
      continue;
    const std::string more = file.text + " 1.0 2.0 3.0 4.0 5.0 6.0 7.0 8.0 9.0\n";
    EXPECT_NE(error_of(more, file.file, {.component = "1"}), "") << file.format;
  }
}

TEST(CountAndStep, EitherOrderAndFreeColumns) {
  for (const char* line : {"4 0.01", "0.01 4", "4, 0.01", "  4   1.0E-2"}) {
    const Record record =
        parsed(fmt::format("a title of 1994\n{}\n1e-3 2e-3\n-3e-3\n0\n", line), "x.txt", {.unit = Unit::g});
    EXPECT_EQ(record.dt, 0.01) << line;
    EXPECT_EQ(record.samples, (std::vector{1e-3, 2e-3, -3e-3, 0.0})) << line;
    EXPECT_EQ(record.origin.format, "count and step");
  }
  EXPECT_EQ(parsed("acceleration (cm/s2)\n3 0.01\n1 2 3\n", "x.txt").unit, Unit::cm_s2);
  EXPECT_THAT(error_of("a title\n3 0.01\n1 2 3\n", "x.txt"), HasSubstr("--unit"));
  EXPECT_THAT(error_of("acceleration (1000 g)\n3 0.01\n1 2 3\n", "x.txt"),
              HasSubstr("'acceleration (1000 g)'"));
  EXPECT_THAT(error_of("a title\n3 0.01\n1 2\n", "x.txt", {.unit = Unit::g}), HasSubstr("3 but there are 2"));
}

TEST(Columns, OfATableAreChosenByNumberOrName) {
  const std::string text = "Time (ms),N-S acc (g),E-W acc (0.1 g),remark\n0,1,2,a\n10,3,4,b\n20,5,6,c\n";
  const Record ew = parsed(text, "x.csv", {.column = "3"});
  EXPECT_EQ(ew.dt, 0.01);
  EXPECT_THAT(ew.samples, ::testing::Pointwise(::testing::DoubleNear(1e-15), {0.2, 0.4, 0.6}));
  EXPECT_EQ(parsed(text, "x.csv", {.column = "n-s"}).samples, (std::vector{1.0, 3.0, 5.0}));
  EXPECT_EQ(error_of(text, "x.csv"), "x.csv:2: a time and a value are needed, found 4 columns: say which "
                                     "holds the motion (--column): 2 'N-S acc "
                                     "(g)', 3 'E-W acc (0.1 g)', 4 'remark'");
  EXPECT_THAT(error_of(text, "x.csv", {.column = "acc"}),
              HasSubstr("'acc' is none of its columns of values, or several"));
  EXPECT_THAT(error_of(text, "x.csv", {.column = "1"}), HasSubstr("'1' is none"));
  EXPECT_THAT(error_of(text, "x.csv", {.component = "1"}), HasSubstr("--column chooses"));
  EXPECT_THAT(error_of(text + "30,7\n", "x.csv", {.column = "2"}), HasSubstr("found 2 columns, before 4"));
  const std::string plain = "0 1 2\n0.01 3 4\n";
  EXPECT_EQ(parsed(plain, "x.txt", {.unit = Unit::g, .column = "3"}).samples, (std::vector{2.0, 4.0}));
  EXPECT_THAT(error_of(plain, "x.txt"), HasSubstr("(--column): 2 to 3"));
  EXPECT_EQ(parsed("time (s) acceleration (m / s2) vel\n0 1 2\n0.01 3 4\n", "x.txt", {.column = "2"}).unit,
            Unit::m_s2);
}

TEST(Columns, DecimalCommasAreNamed) {
  EXPECT_THAT(error_of("Time (s);Acc (g)\n0;0,1\n0,01;0,2\n", "x.csv"), HasSubstr("x.csv:2: decimal commas"));
}

TEST(Columns, TheFirstIsATime) {
  EXPECT_EQ(parsed("t (ms),a (g)\n0,1\n5,2\n", "x.csv").dt, 0.005);
  EXPECT_THAT(error_of("step,a (g)\n0,1\n1,2\n", "x.csv"), HasSubstr("the first column is called 'step'"));
  EXPECT_THAT(error_of("frequency (Hz),a (g)\n0,1\n1,2\n", "x.csv"), HasSubstr("a spectrum is no motion"));
  EXPECT_THAT(error_of("hours,a (g)\n0,1\n1,2\n", "x.csv"), HasSubstr("it must be the time"));
  EXPECT_THAT(error_of("# units: 1000 g\nt,acc\n0,1\n1,2\n", "x.csv"), HasSubstr("1000 g"));
  EXPECT_EQ(parsed("# units: milli-g\nt,acc\n0,1\n1,2\n", "x.csv").samples[1], 2e-3);
  EXPECT_THAT(error_of("# units: milli-g\nt,acc (mili g)\n0,1\n1,2\n", "x.csv"), HasSubstr("'acc (mili g)'"));
  EXPECT_THAT(error_of("# units: milli-g\nt,acc (g)\n0,1\n1,2\n", "x.csv"),
              HasSubstr("0.001 g in a comment"));
  EXPECT_THAT(error_of("# scale factor 0.5\nt,acc (g)\n0,1\n1,2\n", "x.csv"), HasSubstr("scale factor 0.5"));
}

TEST(Peer, FieldsOfFixedWidthThatTouch) {
  const std::string head = "ACCELERATION IN UNITS OF G\nNPTS= 4, DT= .02\n";
  EXPECT_EQ(parsed(head + " 0.000541-0.000624-0.002109\n-0.003872\n", "x.AT2").samples,
            (std::vector{0.000541, -0.000624, -0.002109, -0.003872}));
  EXPECT_EQ(parsed(head + " 1.50E-01-2.50E-02-1.00E+00 2.00E+00\n", "x.AT2").samples,
            (std::vector{0.15, -0.025, -1.0, 2.0}));
  // Not fields of one width: an exponent without its letter, decimals that differ.
  EXPECT_THAT(error_of(head + " 0.123-100 1. 2. 3.\n", "x.AT2"),
              HasSubstr("'0.123-100' is not a finite number"));
  EXPECT_THAT(error_of(head + " 0.12-0.345 1. 2.\n", "x.AT2"), HasSubstr("is not a finite number"));
}

TEST(Samples, BeyondAnyMotionAreRefusedWithTheirValue) {
  EXPECT_EQ(error_of("t,a (g)\n0,0\n0.01,1e300\n", "x.csv"),
            "x.csv:1: sample 2 is 1e+300 g, must be within 1e+06 m/s2");
}

} // namespace
} // namespace tremolo::motion
