// `tremolo deconvolve` as a user calls it: the surface record that a case makes, taken down again, is the
// case's motion.

#include "motion/read/read.hpp"
#include "tests/support/command.hpp"
#include "tests/support/reference_table.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

namespace tremolo::motion {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::tremolo::testing::Outcome;
using ::tremolo::testing::run_tremolo;

constexpr const char* pulse = R"(pulse = { shape = "ricker", frequency = 2.0, time = 1.5, velocity = 0.1 })";
constexpr const char* rock_record = "file = \"rock.csv\"\nkind = \"outcrop\"";

/// 16 m of clay on sand on rock; `clay` completes the soil.
std::string site(const std::string& motion, const std::string& clay = "model = \"linear_elastic\"") {
  return "[motion]\n" + motion + R"(
wave = "SV"
angle_deg = 0
reference = [0, -16]
[surface]
level = 0.0
[halfspace]
density = 2200.0
vs = 600.0
vp = 1200.0
[[profile]]
thickness = 6.0
soil = "clay"
[[profile]]
thickness = 10.0
soil = "sand"
[damping]
model = "hysteretic"
ratio = 0.03
[soil.clay]
density = 1700.0
vs = 140.0
vp = 280.0
)" + clay +
         R"(
[soil.sand]
model = "linear_elastic"
density = 1900.0
vs = 250.0
vp = 500.0
)";
}

class DeconvolveCommand : public ::testing::Test {
protected:
  std::string path(const char* name) const { return (folder / name).string(); }

  /// The surface of a case at 0, 0.01 ... 8 s, m/s.
  std::vector<std::vector<double>> surface(const std::string& text) const {
    const auto [status, output] = run_tremolo(
        "wave " + folder.write("up.toml", text).string() + " --points " +
        folder.write("points.csv", "x,y\n0,0\n").string() + " --times 0:8:0.01 --out " + path("surface.csv"));
    EXPECT_EQ(status, 0) << output;
    return testing::read_table(folder / "surface.csv");
  }

  void write_record(const std::vector<std::vector<double>>& rows, double factor = 1.0) const {
    std::string record = "t (s),velocity (m/s)\n";
    for (const auto& row : rows)
      record += fmt::format("{:.6g},{:.15g}\n", row[0], factor * row[5]);
    folder.write("record.csv", record);
  }

  Outcome deconvolve(const std::string& text, const std::string& options) const {
    return run_tremolo("deconvolve " + folder.write("case.toml", text).string() + " " + path("record.csv") +
                       " --out " + path("rock.csv") + " " + options);
  }

  testing::TemporaryFolder folder;
};

TEST_F(DeconvolveCommand, MakesTheMotionOfTheCase) {
  const auto up = surface(site(pulse));
  write_record(up);
  const auto [status, output] = deconvolve(site(rock_record), "--model wave --plot");
  ASSERT_EQ(status, 0) << output;
  EXPECT_THAT(output, HasSubstr("rock.csv: outcrop motion, "));
  for (const char* words :
       {"  record          PGA ", "  outcrop         PGA ", "  incident        PGA ",
        "  cutoff          15 Hz: whole up to it, nothing above 18.75 Hz\n",
        "  amplification   outcrop over record at most ", "  largest strain  ", "  begins          "})
    EXPECT_THAT(output, HasSubstr(words));
  EXPECT_THAT(output, Not(HasSubstr("warning")));
  EXPECT_GT(std::filesystem::file_size(folder / "rock.png"), 10000U);

  // The outcrop moves twice as the incident pulse: v = V (1 - 2a) exp(-a), a = (pi f (t - t0))^2.
  const Record rock = read_record(folder / "rock.csv");
  EXPECT_EQ(rock.kind, MotionKind::outcrop);
  const auto place = output.find("begins");
  const double lead = std::stod(output.substr(place + 6));
  constexpr double w = std::numbers::pi * 2.0;
  double error = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < rock.samples.size(); ++i) {
    const double t = static_cast<double>(i) * rock.dt - lead - 1.5;
    const double a = w * w * t * t;
    const double exact = 2.0 * 0.1 * 2.0 * w * w * t * (2.0 * a - 3.0) * std::exp(-a);
    error = std::max(error, std::abs(rock.samples[i] - exact));
    largest = std::max(largest, std::abs(exact));
  }
  EXPECT_LT(error, 1e-4 * largest); // the slope of the record's spline
  std::printf("outcrop acceleration: %.1e of the peak\n", error / largest);

  // The case that takes rock.csv shakes its surface as recorded, later by the lead.
  const auto again = surface(site(rock_record));
  const auto shift = static_cast<std::size_t>(std::lround(lead / 0.01));
  double difference = 0.0;
  double highest = 0.0;
  for (std::size_t i = 0; i + shift < again.size(); ++i) {
    difference = std::max(difference, std::abs(again[i + shift][5] - up[i][5]));
    highest = std::max(highest, std::abs(up[i][5]));
  }
  EXPECT_LT(difference, 1e-4 * highest);
  std::printf("surface again: %.1e of the peak\n", difference / highest);
}

TEST_F(DeconvolveCommand, WritesTheIncidentMotionWhereTheCaseTakesIt) {
  write_record(surface(site(pulse)));
  const auto output = deconvolve(site("file = \"rock.csv\"\nkind = \"incident\""), "--model wave").output;
  EXPECT_THAT(output, HasSubstr("rock.csv: incident motion, "));
  EXPECT_EQ(read_record(folder / "rock.csv").kind, MotionKind::incident);
  EXPECT_THAT(
      deconvolve(site("file = \"rock.csv\"\nkind = \"incident\""), "--model wave --as outcrop").output,
      HasSubstr("rock.csv: outcrop motion, "));
  EXPECT_THAT(deconvolve(site("file = \"rock.csv\"\nkind = \"within\""), "--model wave").output,
              HasSubstr("[motion] kind is within"));
}

TEST_F(DeconvolveCommand, FollowsTheStrainOfSoftSoil) {
  write_record(surface(site(pulse)));
  const std::string hyperbolic = "model = \"hyperbolic\"\nreference_strain = 1e-3";
  const auto soft = deconvolve(site(rock_record, hyperbolic), "--model eql");
  EXPECT_EQ(soft.status, 0) << soft.output;
  EXPECT_THAT(soft.output, HasSubstr("  eql             converged after "));
  const auto short_of = deconvolve(site(rock_record, hyperbolic) + "[eql]\niterations = 2\n", "--model eql");
  EXPECT_EQ(short_of.status, 1);
  EXPECT_THAT(short_of.output,
              HasSubstr("case.toml: the equivalent linear analysis has not converged after 2"));
  const auto allowed = deconvolve(
      site(rock_record, hyperbolic) + "[eql]\niterations = 2\nunconverged = \"allow\"\n", "--model eql");
  EXPECT_EQ(allowed.status, 0) << allowed.output;
  EXPECT_THAT(allowed.output, HasSubstr("warning: the equivalent-linear iteration has NOT converged"));
}

TEST_F(DeconvolveCommand, WarnsWhereStrainPassesTheCurves) {
  write_record(surface(site(pulse)));
  folder.write("curve.csv", "strain,modulus_reduction,damping\n1e-6,1,0.02\n1e-5,0.98,0.02\n1e-4,0.8,0.05\n");
  const auto [status, output] =
      deconvolve(site(rock_record, "model = \"mkz\"\ncurve = \"curve.csv\""), "--model eql");
  EXPECT_EQ(status, 0) << output;
  EXPECT_THAT(output, HasSubstr("warning: the effective strain passes the end of the soil's curves in 6 of 7 "
                                "layers, first in the soil from 0 m to 1 m"));
}

TEST_F(DeconvolveCommand, WarnsWhereTheRockShakesMuchMoreThanTheGround) {
  std::string record = "t (s),acceleration (m/s2)\n";
  for (int i = 0; i < 600; ++i) {
    const double t = 0.01 * i;
    record +=
        fmt::format("{:.6g},{:.12g}\n", t,
                    std::exp(-std::pow((t - 3.0) / 0.6, 2)) * std::sin(2.0 * std::numbers::pi * 9.0 * t));
  }
  folder.write("record.csv", record);
  std::string damped = site(rock_record);
  damped.replace(damped.find("ratio = 0.03"), 12, "ratio = 0.30");
  const auto [status, output] = deconvolve(damped, "--model wave --cutoff 10");
  EXPECT_EQ(status, 0) << output;
  EXPECT_THAT(output, HasSubstr("warning: the outcrop's PGA is "));
}

TEST_F(DeconvolveCommand, TakesASensorInTheGround) {
  const auto [status, points] = run_tremolo(
      "wave " + folder.write("up.toml", site(pulse)).string() + " --points " +
      folder.write("points.csv", "x,y\n0,-3\n").string() + " --times 0:8:0.01 --out " + path("sensor.csv"));
  ASSERT_EQ(status, 0) << points;
  write_record(testing::read_table(folder / "sensor.csv"));
  const auto outcome = deconvolve(site(rock_record), "--model wave --depth 3 --cutoff 8");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("3 m below the surface\n"));
  // The largest slope of twice the pulse, 2 V 2 w^2 t (3 - 2a) exp(-a) at a = (3 - sqrt(6))/2.
  constexpr double w = std::numbers::pi * 2.0;
  const double a = 0.5 * (3.0 - std::sqrt(6.0));
  const double exact = 2.0 * 0.1 * 2.0 * w * std::sqrt(a) * (3.0 - 2.0 * a) * std::exp(-a);
  const Record rock = read_record(folder / "rock.csv");
  double largest = 0.0;
  for (const double value : rock.samples)
    largest = std::max(largest, std::abs(value));
  EXPECT_NEAR(largest, exact, 2e-3 * exact);
}

/// The right side's ground is that of site(), 3 m higher, and [[profile]] another one.
TEST_F(DeconvolveCommand, TakesTheGroundOfASide) {
  write_record(surface(site(pulse)));
  EXPECT_EQ(deconvolve(site(rock_record), "--model wave").status, 0);
  const auto exact = read_record(folder / "rock.csv").samples;
  std::string text = site(rock_record);
  text.replace(text.find("thickness = 10.0"), 16, "thickness = 5.0");
  text += R"([boundary]
left = { model = "fe" }
base = { model = "wave" }
[boundary.right]
model = "wave"
surface = 3.0
profile = [{ thickness = 6.0, soil = "clay" }, { thickness = 10.0, soil = "sand" }]
)";
  const auto [status, output] = deconvolve(text, "--model wave --side right");
  ASSERT_EQ(status, 0) << output;
  EXPECT_EQ(read_record(folder / "rock.csv").samples, exact);
  EXPECT_EQ(deconvolve(text, "--model wave --side left").status, 0);
  EXPECT_NE(read_record(folder / "rock.csv").samples, exact);
  const std::string periodic =
      site(rock_record) + "[boundary]\nsides = \"periodic\"\nbase = { model = \"wave\" }\n";
  EXPECT_THAT(deconvolve(periodic, "--model wave --side left").output,
              HasSubstr("the left side is asked for, but sides = \"periodic\" have no free field"));
  EXPECT_THAT(deconvolve(site(rock_record), "--model wave --side left").output,
              HasSubstr("missing table [boundary.left]"));
}

TEST_F(DeconvolveCommand, RefusesInOneLine) {
  const auto up = surface(site(pulse));
  write_record(up);
  const auto refused = [&](const std::string& text, const std::string& options) {
    const auto [status, output] = deconvolve(text, options);
    EXPECT_NE(status, 0) << options;
    return output;
  };
  const std::string good = site(rock_record);
  EXPECT_THAT(refused(good, ""), HasSubstr("--model is required"));
  EXPECT_THAT(refused(good, "--model fe"), HasSubstr("fe"));
  EXPECT_THAT(
      refused(good, "--model wave --cutoff 60"),
      HasSubstr("--cutoff: 60 Hz, must be at most 50 Hz, the highest frequency of a record at steps of "
                "0.01 s"));
  EXPECT_THAT(refused(good, "--model wave --cutoff -1"), HasSubstr("--cutoff"));
  EXPECT_THAT(refused(good, "--model wave --depth 17"),
              HasSubstr("depth of the record is 17, must be from 0 to 16 m"));
  EXPECT_THAT(refused(good, "--model wave --unit g"), HasSubstr("record.csv"));
  std::string steep = site("file = \"rock.csv\"\nkind = \"incident\"");
  steep.replace(steep.find("angle_deg = 0"), 13, "angle_deg = 40");
  EXPECT_THAT(refused(steep, "--model wave --as incident"),
              HasSubstr("case.toml: [motion] angle_deg = 40: beyond the critical angle of the half-space"));
  // Noise: soil that damps more than any is asked for its highest frequencies.
  std::string damped = good;
  damped.replace(damped.find("ratio = 0.03"), 12, "ratio = 0.30");
  const auto amplified = refused(damped, "--model wave --cutoff 40");
  EXPECT_THAT(amplified, HasSubstr("must be at most 10: take a cutoff of "));
  EXPECT_THAT(amplified, Not(HasSubstr("rock.csv: ")));
  // The motions of rock are none of the ground.
  folder.write("record.csv", "t (s),acceleration (m/s2) outcrop\n0,0\n0.01,1\n0.02,0\n");
  EXPECT_THAT(refused(good, "--model wave"), HasSubstr("it says that it is an outcrop motion"));
  EXPECT_FALSE(std::filesystem::exists(folder / "rock.csv"));
}

} // namespace
} // namespace tremolo::motion
