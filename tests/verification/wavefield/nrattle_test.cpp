// The amplification of 295 undamped layers against NRATTLE (C. Mueller, in Boore 2005, SMSIM, U.S. Geological
// Survey Open-File Report 00-509), whose output to four decimals comes with pyStrata.

#include "tests/support/paths.hpp"
#include "tests/support/reference_table.hpp"
#include "wavefield/layers/transfer.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <filesystem>
#include <vector>

namespace {

using namespace tremolo::wavefield;

std::vector<std::vector<double>> table(const char* name) {
  return tremolo::testing::read_table(std::filesystem::path(tremolo::source_dir()) / "tests" /
                                      "verification" / "wavefield" / "nrattle" / name);
}

TEST(Nrattle, AmplificationOfACrust) {
  LayeredHalfSpace crust{.layers = {}, .half_space = {2720.0, 3500.0, 7000.0}};
  for (const auto& row : table("layers.csv"))
    crust.layers.push_back({.thickness = row[0], .density = row[2], .vs = row[1], .vp = 2.0 * row[1]});
  ASSERT_EQ(295U, crust.layers.size());
  const auto rows = table("amplification.csv");
  std::vector<double> frequencies;
  for (const auto& row : rows)
    frequencies.push_back(row[0]);
  const auto found = surface_transfer(crust, WaveType::SV, 0.0, frequencies);
  ASSERT_EQ(33U, found.size());
  constexpr double half_of_the_last_digit = 0.5e-4;
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_NEAR(rows[i][1], std::abs(found[i].to_outcrop), 1.02 * half_of_the_last_digit) << rows[i][0];
}

} // namespace
