#include "motion/record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

namespace tremolo::motion {
namespace {

std::string error_of(const std::string& text) {
  try {
    parse_record(text, "x.AT2");
  } catch (const RecordError& error) {
    return error.what();
  }
  return "";
}

TEST(Record, ReadsHeadersInAnySpelling) {
  for (const char* header :
       {"NPTS=   4, DT=   .0200 SEC   ", "4    0.0200    NPTS, DT", "npts = 4 , dt = 0.02", "NPTS=4,DT=.02D0",
        "0.0200 4 DT, NPTS", "NPTS= 4, DT= .02000 SEC\r"}) {
    const auto record = parse_record(
        fmt::format("A TITLE OF 1994\nACCELERATION IN UNITS OF G\n{}\n .1E-01 -.2 0.3\n +4.D-1\n", header),
        "x");
    EXPECT_DOUBLE_EQ(record.dt, 0.02) << header;
    ASSERT_EQ(record.samples.size(), 4U) << header;
    EXPECT_DOUBLE_EQ(record.samples[1], -0.2) << header;
    EXPECT_DOUBLE_EQ(record.samples[3], 0.4) << header;
  }
}

TEST(Record, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(error_of("title\n0.1 0.2\n"), "x.AT2:2: no header line with NPTS and DT");
  EXPECT_EQ(error_of("NPTS= 2, DT= .01\n0.1\nabc\n"), "x.AT2:3: 'abc' is not a finite number");
  EXPECT_EQ(error_of("NPTS= 2, DT= .01\n0.1 nan\n"), "x.AT2:2: 'nan' is not a finite number");
  EXPECT_EQ(error_of("NPTS= 3, DT= .01\n0.1 0.2\n"),
            "x.AT2:2: the header says NPTS = 3 but there are 2 samples");
  EXPECT_EQ(error_of("NPTS= 3, DT= 0\n0.1 0.2 0.3\n"), "x.AT2:1: DT = 0 s, must be > 0");
  EXPECT_EQ(error_of("NPTS= 1, DT= .01\n0.1\n"), "x.AT2:1: NPTS = 1, must be a whole number from 2 to 1e+08");
  EXPECT_EQ(error_of(""), "x.AT2:1: no header line with NPTS and DT");
}

TEST(RecordMeasures, HarmonicMotion) {
  // a = A sin(w t) for 40 s of 2 Hz: Arias = pi/(2g) A^2 T/2; 5 and 95 % are reached after whole periods, at
  // 2 s and 38 s; v = A/w (1 - cos(w t)) with peak 2A/w.
  const double amplitude = 2.0;
  const double frequency = 2.0;
  const double duration = 40.0;
  const double dt = 1e-3;
  std::vector<double> a(40001);
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] = amplitude * std::sin(2.0 * std::numbers::pi * frequency * static_cast<double>(i) * dt);
  const auto m = measures(a, dt);
  EXPECT_NEAR(m.pga, amplitude, 1e-4);
  EXPECT_NEAR(m.pgv, amplitude / (std::numbers::pi * frequency), 1e-4);
  EXPECT_NEAR(m.arias, std::numbers::pi / (2.0 * standard_gravity) * amplitude * amplitude * duration / 2.0,
              1e-4);
  EXPECT_NEAR(m.significant_duration, 36.0, 5e-3);
  EXPECT_NEAR(m.mean_period, 1.0 / frequency, 5e-3); // leakage of the finite record
  EXPECT_THROW(measures(std::vector<double>{1.0}, dt), std::invalid_argument);
}

TEST(RecordMeasures, BaldwinHillsOfNorthridge) {
  const char* set = std::getenv("TREMOLO_REFERENCE");
  const auto folder =
      std::filesystem::path(set != nullptr ? set : TREMOLO_SOURCE_DIR "/../shared/reference") / "records";
  const auto file = folder / "RSN985_NORTHR_BLD090.AT2";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << file << " is absent; set TREMOLO_REFERENCE to the folder with the reference data";
  auto record = read_record(file);
  ASSERT_EQ(record.samples.size(), 2000U);
  for (double& a : record.samples)
    a *= standard_gravity;
  const auto m = measures(record.samples, record.dt);
  EXPECT_NEAR(m.pga / standard_gravity, 0.238859, 1e-6);
  const double rounded = 9.81 / standard_gravity; // the g of the published measures
  EXPECT_NEAR(m.pgv * rounded, 0.148742, 1e-6);
  EXPECT_NEAR(m.arias * rounded, 0.670262, 1e-6);
  EXPECT_NEAR(m.significant_duration, 16.563, record.dt);

  // The same record's velocities, integrated by those who processed it, in cm/s.
  const auto velocity = read_record(folder / "RSN985_NORTHR_BLD090.VT2");
  const auto ours = integrate(record.samples, record.dt);
  ASSERT_EQ(velocity.samples.size(), ours.size());
  for (std::size_t i = 0; i < ours.size(); ++i)
    ASSERT_NEAR(ours[i], 0.01 * velocity.samples[i], 2e-3 * m.pgv) << i;
}

} // namespace
} // namespace tremolo::motion
