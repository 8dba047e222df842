// The rules of the motion, each with a case that keeps it and one that breaks it, and the message.

#include "rule_cases.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Rules, RecordIsReadable) {
  const auto pulse = "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }";
  EXPECT_THAT(errors_of(with(pulse, "file = \"absent.AT2\"\nkind = \"outcrop\"")),
              ElementsAre("case.toml:3:8: [motion] ./absent.AT2: there is no such file"));

  const auto file = std::filesystem::path(::testing::TempDir()) / "rules_record.AT2";
  std::ofstream(file) << "NPTS= 3, DT= .01 SEC\n0.0 0.1 0.0\n";
  EXPECT_THAT(errors_of(with(pulse, "file = \"" + file.string() + "\"\nkind = \"outcrop\"")), IsEmpty());
  std::ofstream(file) << "NPTS= 4, DT= .01 SEC\n0.0 0.1 0.0\n";
  EXPECT_THAT(errors_of(with(pulse, "file = \"" + file.string() + "\"\nkind = \"outcrop\"")),
              ElementsAre("case.toml:3:8: [motion] " + file.string() +
                          ":2: the header says NPTS = 4 but there are 3 samples"));
  std::filesystem::remove(file);
}

TEST(Rules, AMotionWithinTheGroundIsThatOfTheTopOfTheHalfSpace) {
  const auto within = [](std::string text) {
    return with("[motion]\n", "[motion]\nkind = \"within\"\n", text);
  };
  const std::string damped = "damping = 0.02\n[damping]\nmodel = \"kelvin_voigt\"\nreference_hz = 3.0\n";
  const auto to_the_base = with_columns() + with("thickness = 4.0", "thickness = 10.0", std::string(layer));
  EXPECT_THAT(errors_of(within(to_the_base)), IsEmpty());
  EXPECT_THAT(
      errors_of(within(std::string(flat_case) + std::string(layer) + damped)),
      ElementsAre(
          "case.toml:7:13: [motion] 'reference' at y = -10 of a motion within the ground must be at the "
          "top of the half-space, y = -4"));
  EXPECT_THAT(errors_of(within(with("left = { model = \"fe\" }", "left = { model = \"eql\" }", to_the_base))),
              ElementsAre(::testing::HasSubstr("takes an incident or outcrop motion")));
  const auto wave = with("left = { model = \"fe\" }", "left = { model = \"wave\" }", to_the_base);
  EXPECT_THAT(errors_of(within(wave)), ElementsAre(::testing::HasSubstr("needs damped layers")));
  EXPECT_THAT(errors_of(within(wave) + damped), IsEmpty());
}

TEST(Rules, ReferenceLiesInHalfspace) {
  const auto layered = with_columns() + std::string(layer);
  EXPECT_THAT(errors_of(with("reference = [0.0, -10.0]", "reference = [0.0, -4.0]", layered)), IsEmpty());
  EXPECT_THAT(errors_of(with("reference = [0.0, -10.0]", "reference = [0.0, -3.0]", layered)),
              ElementsAre("case.toml:6:13: [motion] 'reference' at y = -3 lies in the layers, must be in the "
                          "half-space, y <= -4"));
}

TEST(Rules, WaveArrivesAfterStart) {
  EXPECT_THAT(remarks_of(std::string(flat_case)), Not(Contains(HasSubstr("finds it at rest"))));
  EXPECT_THAT(remarks_of(with("time = 1.0", "time = 0.1")),
              Contains(HasSubstr("case.toml:2:1: warning: [motion] the wave reaches the model ")));
}

TEST(Rules, WhatArrivesBeforeTheStartIsToldWithItsMagnitude) {
  // The Ricker pulse of 3 Hz reaches the model when it is given: at its peak, or 1e-12 of it before.
  EXPECT_THAT(remarks_of(with("time = 1.0", "time = 0.0")), Contains(HasSubstr("up to 1e+02 % of the peak")));
  EXPECT_THAT(remarks_of(with("time = 1.0", "time = 0.6")), Not(Contains(HasSubstr("finds it at rest"))));
}

TEST(Rules, MotionEndsBeforeRun) {
  EXPECT_THAT(remarks_of(std::string(flat_case)), Not(Contains(HasSubstr("after the run's end"))));
  EXPECT_THAT(
      remarks_of(with("time = 1.0", "time = 5.0")),
      Contains(HasSubstr("case.toml:2:1: warning: [motion] 100 % of the incident wave's energy reaches the "
                         "model after the run's end at 2 s; the wave ends at 5.7")));
  // A symmetric pulse whose middle arrives at the end.
  EXPECT_THAT(remarks_of(with("time = 1.0", "time = 2.0")),
              Contains(ContainsRegex("motion. (4[5-9]|5[0-5])")));
}

TEST(Rules, UnitIsThatOfHeader) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "rules_unit.AT2";
  std::ofstream(file) << "ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 7, DT= .01 SEC\n"
                         "0.0 0.1 0.0 -0.2 0.0 0.1 0.0\n";
  const auto pulse = "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }";
  const auto text = with(pulse, "file = \"" + file.string() + "\"\nkind = \"outcrop\"");
  EXPECT_THAT(remarks_of(text), Not(Contains(HasSubstr("'unit'"))));
  EXPECT_THAT(remarks_of(with("[motion]\n", "[motion]\nunit = \"g\"\n", text)),
              Not(Contains(HasSubstr("'unit'"))));
  EXPECT_THAT(
      remarks_of(with("[motion]\n", "[motion]\nunit = \"cm/s2\"\n", text)),
      Contains("case.toml:3:8: warning: [motion] 'unit' = \"cm/s2\", but rules_unit.AT2 says \"g\": the "
               "motion is taken 0.00102 times as strong as its file says"));
  std::filesystem::remove(file);
}

TEST(Rules, AFileNeedsAWordForItsMotion) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "rules_kind.AT2";
  std::ofstream(file) << "NPTS= 7, DT= .01 SEC\n0.0 0.1 0.0 -0.2 0.0 0.1 0.0\n";
  const auto pulse = "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }";
  EXPECT_THAT(errors_of(with(pulse, "file = \"" + file.string() + "\"")),
              ElementsAre(HasSubstr("case.toml:2:1: [motion] missing 'kind', which a 'file' needs")));
  EXPECT_THAT(errors_of(with(pulse, "file = \"" + file.string() + "\"\nkind = \"outcrop\"")), IsEmpty());
  std::filesystem::remove(file);
}

TEST(Rules, RecordIsPlausible) {
  const auto pulse = "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }";
  const auto file = std::filesystem::path(::testing::TempDir()) / "rules_plausible.csv";
  const auto text = with(pulse, "file = \"" + file.string() + "\"\nkind = \"outcrop\"");
  std::ofstream(file) << "time (s),acc (g)\n0,0\n0.01,0.1\n0.02,0\n0.03,-0.2\n0.04,0\n0.05,0.1\n0.06,0\n";
  EXPECT_THAT(remarks_of(text), Not(Contains(HasSubstr("PGA"))));
  EXPECT_THAT(
      remarks_of(with("kind = \"outcrop\"", "kind = \"outcrop\"\nscale = 100.0", text)),
      Contains(HasSubstr("case.toml:3:8: warning: [motion] rules_plausible.csv: PGA 20 g, above 2 g")));
  std::filesystem::remove(file);
}

TEST(Rules, AColumnOfTheRecordIsChosen) {
  const auto pulse = "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }";
  const auto file = std::filesystem::path(::testing::TempDir()) / "rules_columns.csv";
  const auto text = with(pulse, "file = \"" + file.string() + "\"\nkind = \"outcrop\"");
  std::ofstream(file) << "time (s),N-S (g),E-W (g)\n0,0,0\n0.01,0.1,0.2\n0.02,0,0\n";
  EXPECT_THAT(errors_of(text),
              ElementsAre(HasSubstr("say which holds the motion (--column): 2 'N-S (g)', 3 'E-W (g)'")));
  EXPECT_THAT(errors_of(with("kind = \"outcrop\"", "kind = \"outcrop\"\ncolumn = \"E-W\"", text)), IsEmpty());
  EXPECT_THAT(errors_of(with("[motion]\n", "[motion]\ncolumn = \"2\"\n")),
              ElementsAre(HasSubstr("'column' does not apply to 'pulse', only to 'file'")));
  std::filesystem::remove(file);
}

TEST(Rules, RecordEndsAtRest) {
  const auto pulse = "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }";
  const auto file = std::filesystem::path(::testing::TempDir()) / "rules_residual.AT2";
  const auto text = with(pulse, "file = \"" + file.string() + "\"\nkind = \"outcrop\"");
  std::ofstream(file) << "NPTS= 4, DT= .01 SEC\n0.0 0.1 0.1 0.0\n";
  EXPECT_THAT(remarks_of(text),
              Contains(HasSubstr("warning: [motion] rules_residual.AT2: residual velocity ")));
  std::ofstream(file) << "NPTS= 7, DT= .01 SEC\n0.0 0.1 0.0 -0.2 0.0 0.1 0.0\n";
  EXPECT_THAT(remarks_of(text), Not(Contains(HasSubstr("residual velocity"))));
  std::filesystem::remove(file);
}

} // namespace
} // namespace tremolo::scene::testing
