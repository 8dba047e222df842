// The two-phase column with PDMY03 and PM4Sand against u-p finite elements with the same laws. What is asked
// of each number is what the reference's own runs (other steps, meshes, integrators, round-off) let it say:
// BANDS.txt.

#include "tests/support/liquefying_column.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace tremolo::freefield::testing {
namespace {

/// A run of the reference; empty where the folder is absent.
LiquefactionHistory stored(const std::string& run) {
  const auto file = tremolo::testing::reference_folder() / "columns_liquefaction" / run / "data.csv";
  LiquefactionHistory history;
  constexpr std::size_t settlement = 6, first_ratio = 12;
  for (const auto& row : tremolo::testing::read_table(file)) {
    history.time.push_back(row[0]);
    history.settlement.push_back(row[settlement]);
    for (std::size_t i = 0; i < depths.size(); ++i)
      history.ratio[i].push_back(row[first_ratio + i]);
  }
  return history;
}

struct Band {
  double low = 0.0, high = 0.0;
};

/// "t50_1s" and so on of a run at a depth, over the variants of the reference.
std::map<std::string, Band> bands(const std::string& run, double depth) {
  std::ifstream stream(tremolo::testing::reference_folder() / "columns_liquefaction" / "BANDS.txt");
  std::map<std::string, Band> found;
  bool here = false;
  std::ostringstream start;
  start << "z=" << depth << ": ";
  const std::regex entry("(\\w+) ([-0-9.e]+)\\.\\.([-0-9.e]+)");
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("### "))
      here = line.starts_with("### " + run + ":");
    else if (here && line.starts_with(start.str()))
      for (std::sregex_iterator i(line.begin(), line.end(), entry), end; i != end; ++i)
        found[(*i)[1]] = {std::stod((*i)[2]), std::stod((*i)[3])};
  }
  return found;
}

void expect_within(double value, const Band& band, double slack, const std::string& what) {
  EXPECT_GE(value, band.low - slack) << what;
  EXPECT_LE(value, band.high + slack) << what;
}

#define SKIP_WITHOUT(history, run)                                                                           \
  if ((history).time.empty())                                                                                \
  GTEST_SKIP() << "columns_liquefaction/" << (run)                                                           \
               << " is absent; set TREMOLO_REFERENCE to the reference data"

/// The law of which a column is reproducible: times to 0.1 s, mean r_u to 0.01, settlement to 3 %.
TEST(Liquefaction, Pdmy03ColumnIsThatOfTheReference) {
  const auto reference = stored("C2");
  SKIP_WITHOUT(reference, "C2");
  const auto ours = computed(pdmy03_column("C2"));
  for (std::size_t i = 0; i < depths.size(); ++i) {
    SCOPED_TRACE(depths[i]);
    for (const double level : {0.5, 0.7, 0.9}) {
      // Near the surface and at 9.5 m r_u creeps past 0.9 at 0.02 a second, or not at all.
      if (level == 0.9 && (depths[i] < 5.0 || depths[i] > 9.0))
        continue;
      EXPECT_NEAR(ours.time_of(i, level), reference.time_of(i, level), 0.1 + 1e-9) << level;
    }
    EXPECT_NEAR(ours.mean(i, 5.0, 15.0), reference.mean(i, 5.0, 15.0), 0.01);
  }
  for (const double time : {15.0, 25.0})
    EXPECT_NEAR(ours.settlement_at(time) / reference.settlement_at(time), 1.0, 0.03) << time;
}

struct Pm4Column {
  const char* run;
  double relative_density, G_o, h_po;
};

class Pm4SandColumn : public ::testing::TestWithParam<Pm4Column> {};

TEST_P(Pm4SandColumn, LiquefiesWhenTheReferenceDoes) {
  const auto& [run, density, G_o, h_po] = GetParam();
  const auto reference = stored(run);
  SKIP_WITHOUT(reference, run);
  const auto ours = computed(pm4sand_column(run, density, G_o, h_po, 1e-4));
  for (std::size_t i = 1; i <= 3; ++i) {
    SCOPED_TRACE(depths[i]);
    auto band = bands(run, depths[i]);
    EXPECT_NEAR(ours.time_of(i, 0.5), reference.time_of(i, 0.5), 0.1);
    expect_within(ours.time_of(i, 0.7), band["t70_1s"], 0.2, "t70");
    expect_within(ours.mean(i, 5.0, 15.0), band["ru_mean_5_15"], 0.02, "mean r_u from 5 to 15 s");
  }
  for (const double time : {15.0, 25.0})
    EXPECT_NEAR(ours.settlement_at(time) / reference.settlement_at(time), 1.0, 0.08) << time;
}

/// Once sand has liquefied, disturbances decide which element strains: elements half as long lie in the bands
/// of the reference's variants, to what one of its own repetitions is off.
TEST_P(Pm4SandColumn, StaysInTheBandsOnceLiquefied) {
  const auto& [run, density, G_o, h_po] = GetParam();
  const auto reference = stored(run);
  SKIP_WITHOUT(reference, run);
  const auto ours = computed(pm4sand_column(run, density, G_o, h_po, 1e-4), 0.25, 1e-4);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    SCOPED_TRACE(depths[i]);
    auto band = bands(run, depths[i]);
    expect_within(ours.mean(i, 5.0, 15.0), band["ru_mean_5_15"], 0.02, "mean r_u from 5 to 15 s");
    // Above and below, r_u creeps past these levels: the reference's own runs differ by seconds.
    if (depths[i] > 9.0)
      continue;
    expect_within(ours.time_of(i, 0.8), band["t80_1s"], depths[i] < 3.0 ? 1.0 : 0.5, "t80");
    if (depths[i] > 3.0)
      expect_within(ours.time_of(i, 0.9), band["t90_1s"], 0.5, "t90");
  }
  for (const double time : {15.0, 25.0})
    EXPECT_NEAR(ours.settlement_at(time) / reference.settlement_at(time), 1.0, 0.08) << time;
}

INSTANTIATE_TEST_SUITE_P(Liquefaction, Pm4SandColumn,
                         ::testing::Values(Pm4Column{"B1", 0.35, 476.0, 0.53},
                                           Pm4Column{"B2", 0.55, 677.0, 0.40}),
                         [](const auto& one) { return one.param.run; });

/// Ten times as permeable, to the end of dissipation: settlement to 5 %, r_u while water leaves to 0.02.
TEST(Liquefaction, PorePressureDissipatesAfterShaking) {
  const auto reference = stored("B3E");
  SKIP_WITHOUT(reference, "B3E");
  const auto ours = computed(pm4sand_column("B3E", 0.55, 677.0, 0.40, 1e-3, 200.0));
  for (const double time : {25.0, 30.0, 40.0, 60.0, 100.0, 200.0})
    for (std::size_t i = 0; i < depths.size(); ++i)
      EXPECT_NEAR(ours.ratio_at(i, time), reference.ratio_at(i, time), 0.02) << depths[i] << " m, " << time;
  for (const double time : {15.0, 25.0, 200.0})
    EXPECT_NEAR(ours.settlement_at(time) / reference.settlement_at(time), 1.0, 0.05) << time;
}

} // namespace
} // namespace tremolo::freefield::testing
