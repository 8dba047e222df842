// The half-space of every reference file halfspace_* (closed form, Faddeeva function beyond the critical
// angle) against the Fourier synthesis: 7 points, 151 times, all seven quantities.

#include "tests/support/reference_table.hpp"
#include "wavefield/layered_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace tremolo::wavefield;

struct ReferenceCase {
  const char* file;
  WaveType wave;
  double angle_deg;
  double tolerance; ///< of the peak of the quantity's kind
};

HalfSpace table_1_soil() {
  const double density = 1700.0;
  const double young = 40e6;
  const double poisson = 0.28;
  const double shear = young / (2.0 * (1.0 + poisson));
  const double p_modulus = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  return {density, std::sqrt(shear / density), std::sqrt(p_modulus / density)};
}

class HalfSpaceReference : public ::testing::TestWithParam<ReferenceCase> {};

TEST_P(HalfSpaceReference, AgreesWithTheClosedForm) {
  const auto file = tremolo::testing::reference_folder() / "waves" / GetParam().file;
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto rows = tremolo::testing::read_table(file);
  constexpr std::size_t times = 151;
  ASSERT_EQ(rows.size(), 7 * times);

  std::vector<Point> points;
  for (std::size_t row = 0; row < rows.size(); row += times) {
    points.push_back({rows[row][1], rows[row][2]});
  }
  const Incidence incidence{GetParam().wave, GetParam().angle_deg * std::numbers::pi / 180.0, 0.0, -40.0};
  const LayeredField field({.half_space = table_1_soil()}, incidence, 0.0, ricker(3.0, 1.0, 0.1));
  const TimeGrid grid{rows[0][0], (rows[times - 1][0] - rows[0][0]) / (times - 1), times};
  const auto histories = field.sample(points, grid);

  constexpr std::array<int, 7> kind_of = {0, 0, 1, 1, 2, 2, 2}; // displacement, velocity, stress
  std::array<double, 3> peak{};
  std::array<double, 3> error{};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const History& h = histories[row / times];
    const std::array<const std::vector<double>*, 7> computed = {&h.ux,  &h.uy,  &h.vx, &h.vy,
                                                                &h.sxx, &h.syy, &h.sxy};
    for (std::size_t q = 0; q < computed.size(); ++q) {
      const auto kind = static_cast<std::size_t>(kind_of[q]);
      const double exact = rows[row][3 + q];
      peak[kind] = std::max(peak[kind], std::abs(exact));
      error[kind] = std::max(error[kind], std::abs((*computed[q])[row % times] - exact));
    }
  }
  const std::array<const char*, 3> names = {"displacement", "velocity", "stress"};
  for (std::size_t kind = 0; kind < names.size(); ++kind) {
    EXPECT_LT(error[kind] / peak[kind], GetParam().tolerance) << names[kind];
    std::printf("%s %s: %.1e of the peak\n", GetParam().file, names[kind], error[kind] / peak[kind]);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, HalfSpaceReference,
                         ::testing::Values(ReferenceCase{"halfspace_SV_0deg.csv", WaveType::SV, 0.0, 1e-9},
                                           ReferenceCase{"halfspace_SV_15deg.csv", WaveType::SV, 15.0, 1e-9},
                                           ReferenceCase{"halfspace_SV_30deg.csv", WaveType::SV, 30.0, 1e-9},
                                           ReferenceCase{"halfspace_SV_33.5deg.csv", WaveType::SV, 33.5,
                                                         1e-9},
                                           ReferenceCase{"halfspace_SV_40deg.csv", WaveType::SV, 40.0, 1e-6},
                                           ReferenceCase{"halfspace_P_30deg.csv", WaveType::P, 30.0, 1e-9}),
                         [](const auto& parameter_info) {
                           return std::string(parameter_info.param.wave == WaveType::SV ? "SV" : "P") +
                                  std::to_string(std::lround(10.0 * parameter_info.param.angle_deg)) +
                                  "tenths";
                         });

} // namespace
