// Real records as their networks publish them: what is read has the number of samples, the step and the peak
// that the files themselves state.

#include "base/samples.hpp"
#include "motion/read/read.hpp"
#include "tests/support/reference_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tremolo::motion {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class NetworkRecords : public ::testing::Test {
protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_))
      GTEST_SKIP() << folder_ << " is absent; set TREMOLO_REFERENCE to the folder with the reference data";
  }

  std::string error_of(const char* file, const ReadAs& as = {}) const {
    try {
      read_record(folder_ / file, as);
    } catch (const RecordError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_ = testing::reference_folder() / "strangers" / "records";
};

struct Expected {
  const char* file;
  const char* component; ///< a part of its name
  const char* format;
  Unit unit;
  double peak; ///< in the unit of the file, as it states it, or the largest sample found with another program
  double file_unit; ///< m/s2
  double rounding;  ///< half of the peak's last digit
  std::size_t count;
  double dt;
};

constexpr double g = standard_gravity;

constexpr Expected files[] = {
    {"NGNH311106302345.EW1", "", "K-NET, KiK-net", Unit::cm_s2, 0.192, 0.01, 5e-4, 12000, 0.01},
    {"0111a.smc", "360", "SMC", Unit::cm_s2, 104.4078, 0.01, 3e-3, 6001, 0.005},
    {"2516b_a.smc", "360", "SMC", Unit::cm_s2, 39.103935, 0.01, 1e-4, 41200, 0.005},
    {"Cosmos12TimeSeriesTest.v1", "340 deg", "COSMOS", Unit::cm_s2, 161.962, 0.01, 5e-4, 7000, 0.01},
    {"us1000hyfh_akbmrp_AKBMR--n.1000hyfh.BNZ.--.acc.V2c", "BNZ", "COSMOS", Unit::cm_s2, 6.851512, 0.01, 1e-5,
     42000, 0.005},
    {"CIWLT.V2", "1: 90 Deg", "CSMIP", Unit::cm_s2, 82.584, 0.01, 5e-4, 15050, 0.02},
    {"CIWLT.V2", "360 Deg", "CSMIP", Unit::cm_s2, 115.846, 0.01, 5e-4, 15029, 0.02},
    {"ce36456p_CE36456.V2", "1: ", "CSMIP", Unit::cm_s2, 267.957, 0.01, 5e-4, 3251, 0.02},
    {"ce36456p_CE36456.V2", "UP", "CSMIP", Unit::cm_s2, 94.805, 0.01, 5e-4, 3250, 0.02},
    {"ce36456p_CE36456.V2", ": 0 DEG", "CSMIP", Unit::cm_s2, 256.231, 0.01, 5e-4, 3250, 0.02},
    {"017m30bt.s0a", "N08W", "USC volume 2", Unit::cm_s2, 242.3945, 0.01, 6e-4, 1887, 0.02},
    {"copiapo1002271.v1", "EW", "CSMIP volume 1", Unit::g, 0.030, g, 5e-4, 7000, 0.01},
    {"copiapo1002271.v1", "NZ", "CSMIP volume 1", Unit::g, 0.016, g, 5e-4, 7000, 0.01},
    {"5522-1.V1", "L1", "BHRC volume 1", Unit::g, 0.159512, 0.1 * g, 1e-9, 9984, 0.005},
    {"5522-1.V1", "T3", "BHRC volume 1", Unit::g, 0.123697, 0.1 * g, 1e-9, 9984, 0.005},
    {"20161113_110259_WTMC_20.V2A", "N28W", "GeoNet V2A", Unit::m_s2, 9733.1, 1e-3, 0.05, 8192, 0.02},
    {"ACAC1709.191", "V", "UNAM", Unit::cm_s2, 25.6114, 0.01, 1e-9, 35600, 0.005},
    {"ACAC1709.191", "N00E", "UNAM", Unit::cm_s2, 58.7394, 0.01, 1e-9, 35600, 0.005},
    {"ACAC1709.191", "N90E", "UNAM", Unit::cm_s2, 42.3377, 0.01, 1e-9, 35600, 0.005},
    {"1-EAS.dat", "U", "CWB", Unit::cm_s2, 0.837, 0.01, 1e-9, 6000, 0.02},
    {"1-EAS.dat", "N", "CWB", Unit::cm_s2, 2.273, 0.01, 1e-9, 6000, 0.02},
    {"20170720223109_0921.txt", "N-S", "NSMN", Unit::cm_s2, 13.200332, 0.01, 1e-9, 28683, 0.01},
    {"20170720223109_0921.txt", "U-D", "NSMN", Unit::cm_s2, 9.840572, 0.01, 1e-9, 28683, 0.01},
};

TEST_F(NetworkRecords, HaveTheSamplesTheStepAndThePeakThatTheyState) {
  for (const Expected& expected : files) {
    SCOPED_TRACE(std::string(expected.file) + " " + expected.component);
    const Record record = read_record(folder_ / expected.file, {.component = expected.component});
    EXPECT_EQ(record.origin.format, expected.format);
    EXPECT_EQ(record.unit, expected.unit);
    EXPECT_EQ(record.samples.size(), expected.count);
    EXPECT_EQ(record.dt, expected.dt);
    EXPECT_NEAR(peak(record.samples) * in_si(record.unit) / expected.file_unit, expected.peak,
                expected.rounding + 1e-12 * expected.peak);
    EXPECT_THAT(record.origin.doubts, IsEmpty());
  }
}

/// GeoNet prints fewer digits of the samples than of the peak.
struct ExpectedPeak {
  const char* file;
  const char* component;
  Unit unit;
  double peak;     ///< as the file states it, in that unit
  double rounding; ///< half of the last digit of peak or samples
};

TEST_F(NetworkRecords, VelocitiesAndDisplacementsHaveThePeaksThatTheyState) {
  for (const auto& [file, component, unit, stated, rounding] :
       {ExpectedPeak{"CIWLT.V2", "1", Unit::cm_s, 6.863, 5e-4},
        {"CIWLT.V2", "1", Unit::cm, 0.836, 5e-4},
        {"ce36456p_CE36456.V2", "1", Unit::cm_s, 28.253, 5e-4},
        {"ce36456p_CE36456.V2", "1", Unit::cm, 5.449, 5e-4},
        {"017m30bt.s0a", "1", Unit::cm_s, 12.05681, 6e-4},
        {"017m30bt.s0a", "1", Unit::cm, 1.42006, 6e-4},
        {"20161113_110259_WTMC_20.V2A", "1", Unit::m_s, 1.01655, 5e-4},
        {"20161113_110259_WTMC_20.V2A", "1", Unit::mm, 234.852, 0.05}}) {
    const Record record =
        read_record(folder_ / file, {.quantity = quantity_of(unit), .component = component});
    EXPECT_EQ(record.unit, unit) << file;
    EXPECT_NEAR(peak(record.samples), stated, rounding * (1.0 + 1e-9)) << file;
    EXPECT_THAT(record.origin.doubts, IsEmpty()) << file;
  }
}

TEST_F(NetworkRecords, WhatIsNoMotionIsNamed) {
  EXPECT_THAT(error_of("CE89146.V3"), HasSubstr("CSMIP volume 3: response spectra, not a motion"));
  EXPECT_THAT(error_of("eqsig_v1p0p1.txt", {.unit = Unit::g, .column = "2"}),
              HasSubstr("a spectrum is no motion"));
  EXPECT_THAT(error_of("CIWLT.V2"),
              HasSubstr("holds 3 components: say which (--component): 1 'Chan 1: 90 Deg'"));
}

TEST_F(NetworkRecords, CountAndStepNeedsItsUnit) {
  EXPECT_THAT(error_of("test_motion_dt0p01.txt"), HasSubstr("(--quantity or --unit)"));
  const Record record = read_record(folder_ / "test_motion_dt0p01.txt", {.unit = Unit::m_s2});
  EXPECT_EQ(record.samples.size(), 4684U);
  EXPECT_EQ(record.dt, 0.01);
  EXPECT_EQ(record.samples.front(), 2.42e-7);
  EXPECT_EQ(record.samples.back(), -3.15e-5);
}

TEST_F(NetworkRecords, FactorsOfUnitsAreTakenOrRefused) {
  const auto motions = folder_.parent_path() / "motions";
  struct Factor {
    const char* file;
    double factor;
  };
  for (const auto& [file, factor] :
       {Factor{"h4.csv", 1e-3}, {"h5.csv", 1e-3}, {"h6.csv", 0.1}, {"h21.csv", 0.01}, {"mg.AT2", 1e-3}}) {
    const Record record = read_record(motions / file);
    EXPECT_EQ(record.unit, Unit::g) << file;
    EXPECT_THAT(record.origin.unit, HasSubstr(name(ScaledUnit{Unit::g, factor}))) << file;
  }
  EXPECT_DOUBLE_EQ(read_record(motions / "h4.csv").samples[1], 0.00077 * 1e-3);
  EXPECT_DOUBLE_EQ(read_record(motions / "h21.csv").samples[1], 0.00077 * 1e-2);
  EXPECT_THROW(read_record(motions / "h20.csv"), RecordError);
  const Record touching = read_record(motions / "run.AT2");
  EXPECT_EQ(touching.samples.size(), 200U);
  EXPECT_EQ(touching.samples[12], 0.000541);
  EXPECT_EQ(touching.samples[13], -0.000624);
}

} // namespace
} // namespace tremolo::motion
