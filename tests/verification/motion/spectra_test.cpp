// Response spectra and measures of a record at the outcrop, within the profile and at the surface of a
// layered site, computed independently, with g = 9.81 m/s2.

#include "motion/measures.hpp"
#include "motion/record.hpp"
#include "motion/spectra.hpp"
#include "tests/support/reference_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <sstream>

namespace tremolo::motion {
namespace {

constexpr double g = 9.81; // of the reference, m/s2
constexpr std::array periods = {0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0};

/// The rows of a table whose first column is a name.
std::vector<std::vector<double>> named_rows(const std::filesystem::path& file) {
  std::vector<std::vector<double>> rows;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with('#') || line.starts_with("motion,"))
      continue;
    std::istringstream cells(line.substr(line.find(',') + 1));
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
      rows.back().push_back(std::stod(cell));
  }
  return rows;
}

TEST(ResponseSpectra, OfTheLayeredSiteAreTheReference) {
  const auto folder = testing::reference_folder() / "waves";
  if (!std::filesystem::exists(folder / "record_BLD090_layered3_ts.csv"))
    GTEST_SKIP() << folder << " is absent; set TREMOLO_REFERENCE to the folder with the reference data";
  const auto series = testing::read_table(folder / "record_BLD090_layered3_ts.csv");
  const auto expected = named_rows(folder / "record_BLD090_layered3.csv");
  ASSERT_EQ(expected.size(), 3U);
  for (std::size_t motion = 0; motion < 3; ++motion) {
    std::vector<double> a;
    for (const auto& row : series)
      a.push_back(g * row[motion + 1]);
    const auto& row = expected[motion];
    const auto m = measures(a, 0.02);
    EXPECT_NEAR(m.pga / g, row[0], 1e-6 * row[0]);
    EXPECT_NEAR(m.pgv, row[1], 1e-6 * row[1]);
    EXPECT_NEAR(m.pgd, row[2], 1e-5 * row[2]);
    EXPECT_NEAR(m.arias * standard_gravity / g, row[3], 1e-5 * row[3]);
    EXPECT_NEAR(m.significant_duration, row[4], 1e-4 * row[4]);
    const auto spectrum = response_spectrum(a, 0.02, periods, 0.05);
    for (std::size_t i = 0; i < periods.size(); ++i)
      EXPECT_NEAR(spectrum[i].acceleration / g, row[5 + i], 1e-6 * row[5 + i])
          << "motion " << motion << ", T = " << periods[i] << " s";
  }
}

} // namespace
} // namespace tremolo::motion
