// A uniform Kelvin-Voigt layer (rho 1800, Vs 200, 30 m, 2 % at 5/3 Hz) on a half-space (rho 2200, Vs 800)
// under a Ricker pulse, against the exact time series of the reference data.

#include "freefield/twophase/two_phase_column.hpp"
#include "tests/support/reference_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;

/// Largest errors of velocity and stress over four levels and 5 s, relative to their peaks.
std::array<double, 2> errors(const std::vector<std::vector<double>>& rows, double size, double dt) {
  const Profile profile{.layers = {{30.0, Elasticity::from_wave_speeds(1800.0, 200.0, 400.0), 0.02}},
                        .half_space = Elasticity::from_wave_speeds(2200.0, 800.0, 1600.0)};
  TwoPhaseColumn column(profile, {size, dt, KelvinVoigtDamping{5.0 / 3.0}}, [](double t) {
    const double a = std::pow(std::numbers::pi * 3.0 * (t - 0.5), 2);
    return Velocity{(1.0 - 2.0 * a) * std::exp(-a), 0.0};
  });
  const std::array<double, 4> levels = {0.0, -7.5, -15.0, -30.0};
  std::array<ColumnSample, 4> samples;
  std::array<double, 2> error{};
  std::array<double, 2> peak{};
  for (const auto& row : rows) {
    while (column.time() < row[0] - 0.5 * dt) {
      column.step();
    }
    column.sample(levels, samples);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      const std::array<double, 2> computed = {samples[level].vx, samples[level].sxy};
      for (std::size_t q = 0; q < 2; ++q) {
        const double expected = row[1 + 2 * level + q];
        error[q] = std::max(error[q], std::abs(computed[q] - expected));
        peak[q] = std::max(peak[q], std::abs(expected));
      }
    }
  }
  return {error[0] / peak[0], error[1] / peak[1]};
}

TEST(ColumnReference, SecondOrderInSpaceAndTime) {
  const auto file = tremolo::testing::reference_folder() / "waves" / "column_uniform_kv_ricker.csv";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto rows = tremolo::testing::read_table(file);
  ASSERT_EQ(rows.size(), 1001U);
  const double dt = 5e-3 / 32.0;
  const auto coarse = errors(rows, 1.0, dt);
  const auto fine = errors(rows, 0.5, dt / 2.0);
  std::printf("velocity %.2e %.2e, stress %.2e %.2e of the peak\n", coarse[0], fine[0], coarse[1], fine[1]);
  for (std::size_t q = 0; q < 2; ++q) {
    EXPECT_GT(std::log2(coarse[q] / fine[q]), 1.9);
    EXPECT_LT(fine[q], 2e-3);
  }
}

} // namespace
