// `tremolo motion` as a user calls it.

#include "motion/make/pulses.hpp"
#include "motion/measures.hpp"
#include "motion/read/read.hpp"
#include "motion/read/write.hpp"
#include "motion/spectra.hpp"
#include "tests/support/command.hpp"
#include "tests/support/network_texts.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/reference_table.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace tremolo::motion {
namespace {

using ::testing::HasSubstr;
using ::tremolo::testing::run_tremolo;

class MotionCommand : public ::testing::Test {
protected:
  MotionCommand() {
    Record pulse = sampled({.amplitude = 0.3, .time = 2.0, .frequency = 2.0}, Unit::m_s, 0.01, 500);
    pulse.kind = MotionKind::outcrop;
    write_record(pulse, file, {});
  }

  std::string path(const char* name) const { return (folder / name).string(); }

  testing::TemporaryFolder folder;
  std::filesystem::path file = folder / "pulse.csv";
};

TEST_F(MotionCommand, PrintsTheMeasures) {
  const auto outcome = run_tremolo("motion " + file.string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("velocity in m/s, 500 samples every 0.01 s (4.99 s), outcrop\n"));
  EXPECT_THAT(outcome.output, HasSubstr("  PGV                            0.3 m/s\n"));
  EXPECT_EQ(outcome.output.find("warning"), std::string::npos) << outcome.output;
}

TEST_F(MotionCommand, SaysWhatItReadAndTakesComponentsApart) {
  std::ofstream(folder / "three.V2") << ::tremolo::testing::csmip_text();
  const auto open = run_tremolo("motion " + path("three.V2"));
  EXPECT_NE(open.status, 0);
  EXPECT_THAT(open.output, HasSubstr("holds 3 components: say which (--component): 1 'CHAN 1: 45 DEG'"));
  const auto outcome = run_tremolo("motion " + path("three.V2") + " --component 2 --out " + path("two.csv"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output,
              HasSubstr("  read as                CSMIP; 'CHAN 2: 90 DEG' of 3 components; unit "
                        "cm/s2 as the file says; baseline: ACCELEROGRAM BANDPASS FILTERED"));
  EXPECT_EQ(read_record(folder / "two.csv").samples[2], -6.0);
  // Towards the perpendicular component by 90 degrees is that component.
  const auto rotated = run_tremolo("motion " + path("three.V2") + " --component 1 --rotate 90 --with " +
                                   path("three.V2") + " --with-component 3 --out " + path("three.csv"));
  EXPECT_EQ(rotated.status, 0) << rotated.output;
  EXPECT_NEAR(read_record(folder / "three.csv").samples[2], -9.0, 1e-12);
}

TEST_F(MotionCommand, WarnsOfMotionsThatNoEarthquakeMakes) {
  std::ofstream(folder / "large.csv") << "t,acc (g)\n0,0\n0.01,3\n0.02,0\n";
  const auto outcome = run_tremolo("motion " + path("large.csv"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output,
              HasSubstr("warning: " + path("large.csv") + ": PGA 3 g, above 2 g: likely another unit"));
}

TEST_F(MotionCommand, ProcessesAndWrites) {
  const auto outcome = run_tremolo("motion " + file.string() +
                                   " --taper 0.5 --resample 0.005 --pga 2 --shift 1 "
                                   "--as incident --out " +
                                   path("out.AT2"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto record = read_record(folder / "out.AT2");
  EXPECT_EQ(record.dt, 0.005);
  EXPECT_EQ(record.kind, MotionKind::incident);
  const auto m = measures(with_unit(record, Unit::m_s2).samples, record.dt);
  EXPECT_NEAR(m.pga, 1.0, 1e-6); // half of the outcrop's 2 m/s2
  EXPECT_NEAR(record.samples[199], 0.0, 1e-12);
  EXPECT_EQ(record.samples.size(), 999U + 200U);
}

TEST_F(MotionCommand, WritesSpectraAndAPicture) {
  const auto outcome = run_tremolo("motion " + file.string() + " --damping 0.1 --response " + path("r.csv") +
                                   " --fourier " + path("f.csv") + " --plot " + path("m.png"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  // 200 periods in even steps of their logarithm and the 105 customary ones, which share both ends.
  EXPECT_EQ(testing::read_table(folder / "r.csv").size(), 303U);
  EXPECT_EQ(testing::read_table(folder / "f.csv").size(), 251U);
  EXPECT_GT(std::filesystem::file_size(folder / "m.png"), 10000U);
}

TEST_F(MotionCommand, MatchesATargetSpectrumAndSaysHowNear) {
  std::ofstream(folder / "target.csv") << "period,acceleration_g\n0.1,0.3\n0.2,0.6\n0.6,0.6\n1.5,0.2\n";
  const auto outcome = run_tremolo("motion " + file.string() + " --match " + path("target.csv") + " --out " +
                                   path("matched.AT2"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("response spectrum within "));
  const auto matched = with_unit(read_record(folder / "matched.AT2"), Unit::m_s2);
  const std::vector<double> periods = {0.2, 0.4, 0.6};
  for (const auto& one : response_spectrum(matched.samples, matched.dt, periods, 0.05))
    EXPECT_NEAR(one.acceleration, 0.6 * standard_gravity, 0.06 * 0.6 * standard_gravity) << one.period;
  const auto refused =
      run_tremolo("motion " + file.string() + " --resample 0.05 --match " + path("target.csv"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.output, HasSubstr("a step of 0.05 s resolves periods from 0.25 s"));
}

/// A table that separates its columns in another way is drawn as it is read.
TEST_F(MotionCommand, DrawsTheTargetSpectrum) {
  std::ofstream(folder / "target.csv")
      << "# acceleration_g; period\n0.3; 0.1\n0.6; 0.2\n0.6; 0.6\n0.2; 1.5\n";
  const auto outcome =
      run_tremolo("motion " + file.string() + " --match " + path("target.csv") + " --plot " + path("m.png"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_GT(std::filesystem::file_size(folder / "m.png"), 10000U);
}

TEST_F(MotionCommand, WarnsOfAResidualVelocityAndCorrectsIt) {
  const auto drifting = folder.write("d.csv", "t,a (m/s2)\n0,1\n0.1,-0.9\n0.2,1\n0.3,0.5\n0.4,0\n");
  const auto outcome = run_tremolo("motion " + drifting.string());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output,
              HasSubstr("warning: " + drifting.string() + ": residual velocity 0.11 m/s, 100 % of PGV"));
  const auto corrected = run_tremolo("motion " + drifting.string() + " --baseline 1");
  EXPECT_EQ(corrected.output.find("warning"), std::string::npos) << corrected.output;
}

TEST_F(MotionCommand, RotatesTwoComponents) {
  const auto outcome = run_tremolo("motion " + file.string() + " --with " + file.string() +
                                   " --rotate 45 --out " + path("r.csv"));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  const auto before = read_record(file);
  const auto after = read_record(folder / "r.csv");
  EXPECT_NEAR(after.samples[200], std::sqrt(2.0) * before.samples[200], 1e-12);
}

TEST_F(MotionCommand, MakesPulsesAndTheMotionOfTheSlope) {
  const auto recipe =
      folder.write("p.toml", "title = \"shaker\"\nkind = \"within\"\ndt = 0.01\nsamples = 2000\n"
                             "[pulse]\nshape = \"centrifuge\"\nunit = \"g\"\namplitude = 0.2\n"
                             "time = 1.0\nfrequency = 1.0\ncycles = 16\nramp_cycles = 4\n");
  const auto pulse = run_tremolo("motion --synthesise " + recipe.string() + " --out " + path("p.AT2"));
  EXPECT_EQ(pulse.status, 0) << pulse.output;
  EXPECT_EQ(read_record(folder / "p.AT2").kind, MotionKind::within);

  const auto slope = run_tremolo("motion --synthesise " + source_dir() +
                                 "/cases/slope_oblique/motion.toml --out " + path("s.AT2"));
  EXPECT_EQ(slope.status, 0) << slope.output;
  EXPECT_EQ(read_record(folder / "s.AT2").samples,
            read_record(source_dir() + "/cases/slope_oblique/motion.AT2").samples);
}

TEST_F(MotionCommand, AUnitThatTheHeaderDeniesIsTold) {
  const auto record = folder / "record.AT2";
  std::ofstream(record) << "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 4, DT= .01 SEC\n0.0 0.1 -0.1 0.0\n";
  EXPECT_THAT(run_tremolo("motion " + record.string() + " --unit cm/s2").output,
              HasSubstr("record.AT2: --unit cm/s2, but the file says g: the motion is taken 0.00102 times as "
                        "strong as its file says\n"));
  EXPECT_THAT(run_tremolo("motion " + record.string() + " --unit g").output,
              ::testing::Not(HasSubstr("the file says")));
}

TEST_F(MotionCommand, RefusesInOneLine) {
  const auto error_of = [](const std::string& arguments) {
    const auto outcome = run_tremolo("motion " + arguments);
    EXPECT_NE(outcome.status, 0);
    return outcome.output;
  };
  EXPECT_EQ(error_of(""), "tremolo: motion: a FILE or --synthesise RECIPE is needed, and not both\n");
  EXPECT_EQ(error_of("absent.AT2"), "tremolo: absent.AT2: there is no such file\n");
  EXPECT_EQ(error_of(file.string() + " --kind free"), "tremolo: --kind 'free' is not known\n");
  EXPECT_EQ(error_of(file.string() + " --band 1,80"), "tremolo: band from 1 to 80 Hz: the corners must rise "
                                                      "and lie below the Nyquist frequency, 50 Hz (0 leaves "
                                                      "a side open)\n");
  EXPECT_THAT(error_of(file.string() + " --damping -1"), HasSubstr("--damping: -1 must be in [0, 0.99]"));
  for (const auto* number : {"--damping nan", "--scale inf", "--shift -inf", "--band 1,nan"})
    EXPECT_THAT(error_of(file.string() + " " + number), HasSubstr("is no finite number")) << number;
  EXPECT_THAT(error_of(file.string() + " --as within"), HasSubstr("from outcrop to within the layers above"));
}

TEST_F(MotionCommand, AGigabyteOnOneLineIsRefusedAtOnce) {
  const auto giant = folder / "giant.AT2";
  std::ofstream(giant) << "NPTS= 2, DT= .01\n1";
  std::filesystem::resize_file(giant, 1000000000); // sparse, zeros
  EXPECT_THAT(run_tremolo("motion " + giant.string()).output,
              HasSubstr("giant.AT2:2: binary data, not text"));
}

} // namespace
} // namespace tremolo::motion
