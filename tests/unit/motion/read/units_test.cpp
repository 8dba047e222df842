// Units in headers. Each spelling has its meaning worked out by hand; the property test draws thousands of
// headers from words that mean a known factor and words that nobody defined, and holds that a factor is taken
// or the header refused by name, never that the samples pass unscaled.

#include "motion/read/read.hpp"
#include "motion/read/units.hpp"
#include "tests/support/text_mutator.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <sstream>

namespace tremolo::motion {
namespace {

using ::testing::HasSubstr;

/// What one of a stated unit is in SI units; 0 where the text is not understood, -1 where it names no unit.
double si_of(std::string_view text) {
  const Stated stated = stated_in(text);
  if (!stated.strange.empty())
    return 0.0;
  return stated.unit ? in_si(*stated.unit) : -1.0;
}

constexpr double g = standard_gravity;

TEST(Units, SpellingsThatAreTaken) {
  struct Spelling {
    const char* text;
    double si;
  };
  for (const auto& [text, si] : {Spelling{"acc (g)", g},
                                 {"Acceleration (0.1 g)", 0.1 * g},
                                 {"acc [milli-g]", 1e-3 * g},
                                 {"acc [milli g]", 1e-3 * g},
                                 {"acc (mg)", 1e-3 * g},
                                 {"a (x 1e-3 g)", 1e-3 * g},
                                 {"a (\u00d7 10\u207b\u00b3 g)", 1e-3 * g},
                                 {"acc in 10^-3 g", 1e-3 * g},
                                 {"acc (10**-3 g)", 1e-3 * g},
                                 {"acc (1E-03*g)", 1e-3 * g},
                                 {"acc (1/1000 g)", 1e-3 * g},
                                 {"acc (g/1000)", 1e-3 * g},
                                 {"acc (G/10)", 0.1 * g},
                                 {"acc (%g)", 0.01 * g},
                                 {"acc (% of g)", 0.01 * g},
                                 {"Acceleration in percent of g", 0.01 * g},
                                 {"acc, per cent of g", 0.01 * g},
                                 {"acc in thousandths of g", 1e-3 * g},
                                 {"acceleration (cm/s/s) outcrop", 0.01},
                                 {"acc_cm_s2", 0.01},
                                 {"a_m_s2", 1.0},
                                 {"acc (CM/SEC**2)", 0.01},
                                 {"acc (cm s-2)", 0.01},
                                 {"acc (m s^-2)", 1.0},
                                 {"acc (m\u00b7s\u207b\u00b2)", 1.0},
                                 {"acc (m/s\xb2)", 1.0},
                                 {"acc (m/(s^2))", 1.0},
                                 {"acc (mm/s2)", 1e-3},
                                 {"acc (gal)", 0.01},
                                 {"acc (mGal)", 1e-5},
                                 {"acc (ft/s2)", 0.3048},
                                 {"acc (in/sec^2)", 0.0254},
                                 {"acc (metres per second squared)", 1.0},
                                 {"velocity (mm/s)", 1e-3},
                                 {"v_cm_s", 0.01},
                                 {"displacement (mm)", 1e-3},
                                 {"surface_acc_g", g},
                                 {"ACC1 (g)", g},
                                 {"HNE Wallace acceleration (g)", g}})
    EXPECT_NEAR(si_of(text), si, 1e-12 * si) << text;
}

TEST(Units, WhatMayBeAFactorAndIsNotUnderstoodIsStrange) {
  for (const char* text : {"acc (1000 g)",
                           "acc (m/s^2) x 100",
                           "acc (m/s^2) * 100",
                           "acc x 100 (m/s2)",
                           "100 x acc (g)",
                           "acc (g x 1e-3)",
                           "acc (g) 1e-3",
                           "acc (mili g)",
                           "mili acc_g scaled",
                           "acc (kilo g)",
                           "acc (g*9.81)",
                           "acc (10-3 g)",
                           "acc (10^3 g)",
                           "acc (0 g)",
                           "acc (-1 g)",
                           "acc (nan g)",
                           "acc (furlong)",
                           "acc (g) of 981",
                           "acc (cm/s2 to the power)",
                           "acc (cm/s3)",
                           "acc (cm/s2/s)",
                           "acc (m s)",
                           "acc (%)",
                           "acc (g) (m/s2)",
                           "velocity (g)",
                           "acc (normalised g)",
                           "acc (counts)",
                           "acc scaled (g)",
                           "acc (g^2)",
                           "acc (1/g)",
                           "acc (g) percent",
                           "acc (\xff g)"})
    EXPECT_EQ(si_of(text), 0.0) << text;
  for (const char* text : {"velocity", "N-S", "acceleration outcrop", "value", ""})
    EXPECT_EQ(si_of(text), -1.0) << text;
}

TEST(Units, InTheUnitsOfPeer) {
  struct Units {
    const char* text;
    double factor;
  };
  const auto file = [](const char* units) {
    return fmt::format(
        "A TITLE, M 6.7\nACCELERATION TIME SERIES IN UNITS OF {}\nNPTS= 2, DT= .01\n 1. -0.5\n", units);
  };
  for (const auto& [text, factor] : {Units{"G", 1.0},
                                     {"%G", 0.01},
                                     {"10^-3 G", 1e-3},
                                     {"MILLI-G", 1e-3},
                                     {"0.1 G", 0.1},
                                     {"G/10. FILTER: 20 Hz", 0.1},
                                     {"PERCENT OF G", 0.01}}) {
    std::istringstream stream(file(text));
    const Record record = parse_record(stream, "x.AT2");
    EXPECT_EQ(record.unit, Unit::g) << text;
    EXPECT_NEAR(record.samples[0], factor, 1e-15) << text;
  }
  for (const char* text : {"1000 G", "G X 1000", "G*1000", "FURLONG", "G AND SO ON", "10 3 G"}) {
    std::istringstream stream(file(text));
    EXPECT_THROW(parse_record(stream, "x.AT2"), RecordError) << text;
  }
  std::istringstream before("ACCELERATION X 1000 IN UNITS OF G\nNPTS= 2, DT= .01\n 1. -0.5\n");
  EXPECT_THROW(parse_record(before, "x.AT2"), RecordError);
}

TEST(Units, AFactorThatTheCallerOverrulesIsReported) {
  std::istringstream known("t,acc (milli-g)\n0,1\n0.01,2\n");
  const Record record = parse_record(known, "x.csv", {.unit = Unit::g});
  EXPECT_EQ(record.overruled_unit, (ScaledUnit{Unit::g, 1e-3}));
  EXPECT_EQ(record.samples[1], 2.0);
  std::istringstream unknown("t,acc (1000 g)\n0,1\n0.01,2\n");
  const Record told = parse_record(unknown, "x.csv", {.unit = Unit::g});
  EXPECT_THAT(told.origin.doubts, ::testing::ElementsAre(HasSubstr("the header says 'acc (1000 g)'")));
}

struct Part {
  std::string_view text;
  double factor; ///< 0 where nobody can say
};

TEST(Units, DrawnHeadersAreTakenWithTheirFactorOrRefused) {
  constexpr std::array factors = {Part{"", 1.0},           Part{"% ", 0.01},         Part{"milli-", 1e-3},
                                  Part{"1e-3 ", 1e-3},     Part{"x 0.01 ", 0.01},    Part{"10^-2 ", 1e-2},
                                  Part{"0.5 ", 0.5},       Part{"1000 ", 0.0},       Part{"mili ", 0.0},
                                  Part{"kilo", 0.0},       Part{"10 3 ", 0.0},       Part{"thousand ", 0.0},
                                  Part{"1/100 of ", 0.01}, Part{"percent of ", 0.01}};
  constexpr std::array bases = {Part{"g", g},         Part{"G", g},         Part{"gal", 0.01},
                                Part{"cm/s2", 0.01},  Part{"m/s/s", 1.0},   Part{"mm/s^2", 1e-3},
                                Part{"m s-2", 1.0},   Part{"ft/s2", .3048}, Part{"m/s3", 0.0},
                                Part{"furlong", 0.0}, Part{"g2", 0.0}};
  constexpr std::array behind = {Part{"", 1.0},     Part{"/10", 0.1},      Part{" x 100", 0.0},
                                 Part{"*10", 0.0},  Part{" times 5", 0.0}, Part{" e-3", 0.0},
                                 Part{" 1000", 0.0}};
  constexpr std::array open = {"(", "[", "in ", ""};
  constexpr std::array close = {")", "]", "", ""};
  constexpr std::array after = {Part{"", 1.0}, Part{" outcrop", 1.0}, Part{" x 100", 0.0},
                                Part{" (corrected)", 1.0}};
  constexpr std::array names = {Part{"acc ", 1.0}, Part{"Acceleration ", 1.0}, Part{"a ", 1.0},
                                Part{"Acc. N-S ", 1.0}, Part{"1000 acc ", 0.0}};
  tremolo::testing::Draw draw(11);
  const auto one_of = [&](const auto& all) { return all[draw.below(all.size())]; };
  int taken = 0;
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto [name, factor, base, more, last] =
        std::tuple(one_of(names), one_of(factors), one_of(bases), one_of(behind), one_of(after));
    const std::size_t bracket = draw.below(open.size());
    const std::string header = fmt::format("{}{}{}{}{}{}{}", name.text, open[bracket], factor.text, base.text,
                                           more.text, close[bracket], last.text);
    const double exact = name.factor * factor.factor * base.factor * more.factor * last.factor;
    std::istringstream stream(fmt::format("time (s),{}\n0,0\n0.01,1\n", header));
    try {
      const Record record = with_unit(parse_record(stream, "x.csv"), Unit::m_s2);
      ASSERT_NEAR(record.samples[1], exact, 1e-12 * exact) << header;
      ++taken;
    } catch (const RecordError& error) {
      ASSERT_THAT(error.what(), ::testing::AnyOf(HasSubstr("is not wholly understood"), HasSubstr("--unit")))
          << header;
      ++refused;
    }
  }
  EXPECT_GT(taken, 1000);
  EXPECT_GT(refused, 1000);
}

TEST(Units, OfTheFirstColumn) {
  for (const char* name : {"t", "Time", "time (s)", "Time [sec]", "t_s", "time (seconds)"})
    EXPECT_EQ(seconds_per_time(name), 1.0) << name;
  for (const char* name : {"t (ms)", "Time [msec]", "time_ms", "milliseconds"})
    EXPECT_EQ(seconds_per_time(name), 1e-3) << name;
  for (const char* name :
       {"step", "n", "sample", "frequency (Hz)", "period", "time (x 0.01 s)", "t 2", "", "time (h)"})
    EXPECT_EQ(seconds_per_time(name), std::nullopt) << name;
}

} // namespace
} // namespace tremolo::motion
