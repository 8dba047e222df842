#pragma once

// What $TREMOLO_REFERENCE/columns_liquefaction holds of a column: its history, and the bands that runs with
// other steps, meshes, integrators and rounding span.

#include "tests/support/liquefying_column.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <sstream>

namespace tremolo::freefield::testing {

/// A run of the reference; empty where the folder is absent.
inline LiquefactionHistory stored(const std::string& run) {
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

inline constexpr double never = std::numeric_limits<double>::infinity();

struct Band {
  double low = 0.0, high = 0.0;
};

/// Over the variants of a run of the reference: "t50_1s" and so on at a depth, or of the whole column,
/// "settle_15s_mm" and so on. What some variants never reach ends at infinity.
inline std::map<std::string, Band> bands(const std::string& run, std::optional<double> depth) {
  std::ifstream stream(tremolo::testing::reference_folder() / "columns_liquefaction" / "BANDS.txt");
  std::map<std::string, Band> found;
  bool here = false;
  std::ostringstream start;
  if (depth)
    start << "z=" << *depth << ": ";
  else
    start << "pga_all_steps ";
  const std::regex entry("([\\w.]+) ([-0-9.e]+)\\.\\.([-0-9.e]+)( \\([^)]*never\\))?|([\\w.]+) - ");
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("### "))
      here = line.starts_with("### " + run + ":");
    else if (here && line.starts_with(start.str()))
      for (std::sregex_iterator i(line.begin(), line.end(), entry), end; i != end; ++i) {
        if ((*i)[5].matched)
          found[(*i)[5]] = {never, never};
        else
          found[(*i)[1]] = {std::stod((*i)[2]), (*i)[4].matched ? never : std::stod((*i)[3])};
      }
  }
  return found;
}

inline void expect_within(double value, const Band& band, double slack, const std::string& what) {
  EXPECT_GE(value, band.low - slack) << what;
  EXPECT_LE(value, band.high + slack) << what;
}

#define SKIP_WITHOUT(history, run)                                                                           \
  if ((history).time.empty())                                                                                \
  GTEST_SKIP() << "columns_liquefaction/" << (run)                                                           \
               << " is absent; set TREMOLO_REFERENCE to the reference data"

} // namespace tremolo::freefield::testing
