// Real records: every file of the reference set is read, and integration agrees with the velocities and
// displacements that those who processed the record published.

#include "motion/measures.hpp"
#include "motion/read/read.hpp"
#include "tests/support/reference_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::motion {
namespace {

class Records : public ::testing::Test {
protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_))
      GTEST_SKIP() << folder_ << " is absent; set TREMOLO_REFERENCE to the folder with the reference data";
  }

  std::filesystem::path folder_ = testing::reference_folder() / "records";
};

struct Expected {
  const char* file;
  Unit unit;
  std::size_t count;
  double dt;
  double first;
  double last;
};

/// As the files themselves say and begin and end.
constexpr Expected files[] = {
    {"A-ELC180.AT2", Unit::g, 4000, 0.01, .1181069E-02, .3967445E-03},
    {"A-TIN000.AT2", Unit::g, 7996, 0.005, .9690759E-04, -.9299187E-05},
    {"ARL360.at2", Unit::g, 2000, 0.02, .1297983E-02, -.1822073E-03},
    {"EUR090.AT2", Unit::g, 2200, 0.02, .2152965E-03, .1668745E-03},
    {"NIS090.AT2", Unit::g, 4096, 0.01, 0.233833E-06, 0.496963E-04},
    {"RSN985_NORTHR_BLD-UP.AT2", Unit::g, 2000, 0.02, .3042846E-02, -.1209605E-03},
    {"RSN985_NORTHR_BLD-UP.VT2", Unit::cm_s, 2000, 0.02, 0.0, .2570117E-02},
    {"RSN985_NORTHR_BLD-UP.DT2", Unit::cm, 2000, 0.02, 0.0, .1018744E-01},
    {"RSN985_NORTHR_BLD090.AT2", Unit::g, 2000, 0.02, -.8084859E-03, .7310588E-04},
    {"RSN985_NORTHR_BLD360.AT2", Unit::g, 2000, 0.02, -.2553480E-02, -.2203278E-04},
    {"WGK-N.AT2", Unit::g, 11800, 0.005, .5824566E-04, -.3018803E-03},
    {"elCentro.AT2", Unit::g, 1559, 0.02, 0.00630, 0.0},
};

TEST_F(Records, OfEveryHeaderDialectAreRead) {
  for (const Expected& expected : files) {
    const auto record = read_record(folder_ / expected.file);
    EXPECT_EQ(record.unit, expected.unit) << expected.file;
    EXPECT_EQ(record.dt, expected.dt) << expected.file;
    ASSERT_EQ(record.samples.size(), expected.count) << expected.file;
    EXPECT_EQ(record.samples.front(), expected.first) << expected.file;
    EXPECT_EQ(record.samples.back(), expected.last) << expected.file;
  }
}

TEST_F(Records, TablesOfTimeAndValueAreRead) {
  const auto record = read_record(folder_ / "deepsoil_v61_from_pystrata" / "ChiChi_input_outcrop.csv");
  EXPECT_EQ(record.unit, Unit::g);
  EXPECT_EQ(record.kind, MotionKind::outcrop);
  EXPECT_EQ(record.dt, 0.005);
  const auto prenolin = read_record(folder_ / "prenolin_P1_sem2dpack" / "inputp1", {.unit = Unit::m_s});
  EXPECT_EQ(prenolin.dt, 0.001);
}

double largest_difference(const Record& ours, const Record& published) {
  EXPECT_EQ(ours.samples.size(), published.samples.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < ours.samples.size(); ++i)
    largest = std::max(largest, std::abs(ours.samples[i] - published.samples[i]));
  return largest;
}

TEST_F(Records, IntegrationIsThePublishedVelocityAndDisplacement) {
  for (const std::string component : {"BLD090", "BLD360", "BLD-UP"}) {
    const auto file = [&](const char* extension) {
      return folder_ / ("RSN985_NORTHR_" + component + extension);
    };
    const auto acceleration = read_record(file(".AT2"));
    const double velocity =
        largest_difference(with_unit(acceleration, Unit::cm_s), read_record(file(".VT2")));
    const double displacement =
        largest_difference(with_unit(acceleration, Unit::cm), read_record(file(".DT2")));
    EXPECT_LT(velocity, 0.01) << component << ", cm/s";
    EXPECT_LT(displacement, 0.004) << component << ", cm";
    RecordProperty(component + "_velocity_cm_s", std::to_string(velocity));
    RecordProperty(component + "_displacement_cm", std::to_string(displacement));
  }
}

TEST_F(Records, MeasuresOfBaldwinHills) {
  const auto record = with_unit(read_record(folder_ / "RSN985_NORTHR_BLD090.AT2"), Unit::m_s2);
  const auto m = measures(record.samples, record.dt);
  const double rounded = 9.81 / standard_gravity; // the g of the published measures
  EXPECT_NEAR(m.pga / standard_gravity, 0.238859, 1e-6);
  EXPECT_NEAR(m.pgv * rounded, 0.148742, 1e-6);
  EXPECT_NEAR(m.pgd * rounded, 0.0612793870, 1e-6);
  EXPECT_NEAR(m.arias * rounded, 0.670262, 1e-6);
  EXPECT_NEAR(m.significant_duration, 16.563, 1e-3);
  EXPECT_FALSE(residual_warning(m));
}

} // namespace
} // namespace tremolo::motion
