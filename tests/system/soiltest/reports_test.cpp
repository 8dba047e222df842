// What the results of a soil test file say, in print and as tables.

#include "app/soiltest/soiltest_output.hpp"
#include "app/soiltest/soiltest_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tremolo::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* elastic = "model = \"linear_elastic\"\nyoung = 26e6\npoisson = 0.3\ndensity = 1700.0\n";

scene::SoilTestFile file(const std::string& soil, const std::string& test, const std::string& loading) {
  const std::string text = "title = \"report\"\n[soil]\n" + soil + "[test]\nvertical_stress = 100e3\n" +
                           test + "[loading]\n" + loading;
  return scene::parse_soil_test(text, "report.toml", ".", scene::SoilTestUse::test);
}

std::string printed(const scene::SoilTestFile& file) {
  return results_text(file, run(file));
}

const results::Table* table(const std::vector<results::NamedTable>& tables, const std::string& path) {
  for (const auto& one : tables)
    if (one.path == path)
      return &one.table;
  return nullptr;
}

template <class Value>
std::vector<Value> column(const results::Table* table, const std::string& name) {
  if (table != nullptr)
    for (const auto& one : table->columns)
      if (one.name == name)
        return std::get<std::vector<Value>>(one.values);
  ADD_FAILURE() << "no column " << name;
  return {Value{}};
}

std::string monotonic(const std::string& kind) {
  return printed(file(elastic, "kind = \"" + kind + "\"\ndrainage = \"drained\"\n",
                      "kind = \"monotonic\"\nstrain = 1e-3\n"));
}

/// E = 26 MPa, nu = 0.3: M = 35 MPa, K = 21.67 MPa, q = E eps_a, eps_v = (1 - 2 nu) eps_a.
TEST(SoilTestReport, SaysWhatEachTestIsMadeFor) {
  EXPECT_THAT(monotonic("oedometer"),
              AllOf(HasSubstr("constrained modulus 3.5e+07 Pa"), HasSubstr("settlement strain 0.001")));
  EXPECT_THAT(monotonic("isotropic_compression"),
              AllOf(HasSubstr("bulk modulus 2.167e+07 Pa"), HasSubstr("volumetric strain 0.003")));
  EXPECT_THAT(monotonic("triaxial_compression"), // asin(26/226) = 6.61 deg
              AllOf(HasSubstr("peak q 2.6e+04 Pa"), HasSubstr("mobilised angle 6.61 deg"),
                    HasSubstr("volumetric strain 0.0004")));
  EXPECT_THAT(monotonic("direct_simple_shear"), HasSubstr("peak shear stress 1e+04 Pa"));
}

/// G = E/(2 (1 + nu)) = 10 MPa at gamma = (1 + nu) eps_a.
TEST(SoilTestReport, LoopsOfStrainCyclesArePrintedAndWritten) {
  const auto cycles = file(elastic, "kind = \"triaxial_compression\"\ndrainage = \"drained\"\n",
                           "kind = \"cyclic_strain\"\nstrain_amplitude = [1e-4, 1e-3]\ncycles = 2\n");
  const auto done = run(cycles);
  EXPECT_THAT(results_text(cycles, done), AllOf(HasSubstr("damping"), HasSubstr("0.0013         1e+07")));
  const auto tables = soiltest_tables(cycles, done);
  const auto* loops = table(tables, "/tests/000/loops");
  const auto modulus = column<double>(loops, "shear_modulus");
  ASSERT_EQ(modulus.size(), 4U);
  EXPECT_NEAR(modulus[3], 10e6, 10.0);
  EXPECT_NEAR(column<double>(loops, "shear_strain")[3], 1.3e-3, 1e-9);
  EXPECT_EQ(column<double>(loops, "cycle")[3], 2.0);
}

TEST(SoilTestReport, StressesThatWereMissedAreReported) {
  const auto cycles =
      file("library = \"pdmy03_dr57\"\n", "kind = \"direct_simple_shear\"\ndrainage = \"drained\"\n",
           "kind = \"cyclic_strain\"\nstrain_amplitude = [0.01]\ncycles = 2\n");
  const auto done = run(cycles);
  EXPECT_THAT(results_text(cycles, done), HasSubstr("the vertical stress was missed by up to 0."));
  const auto missing =
      column<double>(table(soiltest_tables(cycles, done), "/summary"), "largest_missing_stress");
  EXPECT_GT(missing.front(), 10.0);
  EXPECT_LT(missing.front(), 0.05 * 100e3);
  EXPECT_THAT(monotonic("triaxial_compression"), Not(HasSubstr("missed")));
}

/// Loose sand of PDMY03 under drained simple shear at 200 kPa has no strain near at gamma = 0.00133.
TEST(SoilTestReport, SaysWhereTheStrainLeapsAndHowFar) {
  const auto leaping = [](double vertical_stress) {
    auto one = file("model = \"pdmy03\"\nrelative_density = 0.33\n",
                    "k0 = 1.0\nkind = \"direct_simple_shear\"\ndrainage = \"drained\"\n",
                    "kind = \"monotonic\"\nstrain = 0.005\n");
    one.test.initial.vertical_stress = vertical_stress;
    return printed(one);
  };
  EXPECT_THAT(leaping(200e3), AllOf(HasSubstr("note: monotonic: the law is not unique. "),
                                    HasSubstr("first at gamma = 0.00133 (eps_yy = "),
                                    HasSubstr("no strain near the last increments holds the vertical stress; "
                                              "the strain leaps by up to 1.5e-05 (1.5 increments)")));
  EXPECT_THAT(leaping(50e3), Not(HasSubstr("not unique")));
}

TEST(SoilTestReport, LeavesOutWhatHasNoMeaning) {
  const auto clay = file("model = \"multi_yield_clay\"\ndensity = 1700.0\nvs = 150.0\n"
                         "vp = 300.0\nundrained_strength = 40e3\n",
                         "kind = \"direct_simple_shear\"\ndrainage = \"constant_volume\"\n",
                         "kind = \"cyclic_stress\"\nstress_ratio = 0.2\nmost_cycles = 2\n");
  const auto done = run(clay);
  EXPECT_THAT(results_text(clay, done), HasSubstr("note: multi_yield_clay is a law in total stress"));
  EXPECT_TRUE(
      std::isnan(column<double>(table(soiltest_tables(clay, done), "/summary"), "largest_ru").front()));
}

TEST(SoilTestReport, SaysInWhichPlaneTheStressPathIs) {
  const auto path = [](const std::string& soil) {
    const auto one = file(soil, "kind = \"direct_simple_shear\"\ndrainage = \"drained\"\n",
                          "kind = \"monotonic\"\nstrain = 1e-4\n");
    return column<std::string>(table(soiltest_tables(one, run(one)), "/about"), "stress_path").front();
  };
  EXPECT_EQ(path("library = \"pm4sand_dr55\"\n"), "in_plane");
  EXPECT_EQ(path("library = \"pdmy03_dr57\"\n"), "in_space");
}

} // namespace
} // namespace tremolo::app
