// The marched column against the closed form of oblique waves in a homogeneous half-space, at several depths
// and distances along x, all quantities, as element and step are halved.

#include "freefield/marched/marched_column.hpp"
#include "tests/support/reference_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;

/// So small that elements keep their length: the closed form holds for small strain.
constexpr double scale = 1e-4;

double ricker(double t) {
  const double a = std::pow(std::numbers::pi * 3.0 * (t - 1.0), 2);
  return 0.1 * (1.0 - 2.0 * a) * std::exp(-a);
}

struct Case {
  const char* file;
  bool shear;
  double angle_deg;
  double reference_y;
  Profile profile; ///< down to the lowest point of the file
  double element, step;
  double largest_error; ///< at half of both
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.file;
}

Case half_space(const char* file, bool shear, double angle_deg) {
  const Elasticity soil{1700.0, 40e6, 0.28};
  return {file, shear, angle_deg, -40.0, {.layers = {{40.0, soil}}, .half_space = soil}, 0.5, 2e-3, 3e-3};
}

constexpr std::array<const char*, 7> names = {"ux", "uy", "vx", "vy", "sxx", "syy", "sxy"};

std::array<double, 7> values(const ColumnSample& s) {
  return {s.ux, s.uy, s.vx, s.vy, s.sxx, s.syy, s.sxy};
}

/// Largest error of each quantity over the file, relative to its peak.
std::array<double, 7> errors(const Case& c, const std::vector<std::vector<double>>& rows, double element,
                             double step) {
  const double angle = c.angle_deg * std::numbers::pi / 180.0;
  const double speed = c.shear ? c.profile.half_space.s_wave_speed() : c.profile.half_space.p_wave_speed();
  const double p = std::sin(angle) / speed;
  std::array<double, 7> error{}, peak{};
  std::size_t i = 0;
  while (i < rows.size()) {
    const double x = rows[i][1], y = rows[i][2];
    const double delay = p * x + std::cos(angle) / speed * (c.profile.base_level() - c.reference_y);
    MarchedColumn column(c.profile, {.max_element_size = element, .time_step = step, .slowness_x = p},
                         [&](double t) {
                           const double v = scale * ricker(t - delay);
                           return c.shear ? Velocity{v * std::cos(angle), -v * std::sin(angle)}
                                          : Velocity{v * std::sin(angle), v * std::cos(angle)};
                         });
    for (; i < rows.size() && rows[i][1] == x && rows[i][2] == y; ++i) {
      while (column.time() < rows[i][0] - 0.5 * step) {
        column.step();
      }
      ColumnSample sample;
      column.sample({&y, 1}, {&sample, 1});
      const auto computed = values(sample);
      for (std::size_t q = 0; q < names.size(); ++q) {
        error[q] = std::max(error[q], std::abs(computed[q] / scale - rows[i][3 + q]));
        peak[q] = std::max(peak[q], std::abs(rows[i][3 + q]));
      }
    }
  }
  for (std::size_t q = 0; q < names.size(); ++q) {
    error[q] /= peak[q] > 0.0 ? peak[q] : 1.0;
  }
  return error;
}

class MarchedInHalfSpace : public testing::TestWithParam<Case> {};

TEST_P(MarchedInHalfSpace, ConvergesAtSecondOrder) {
  const Case& c = GetParam();
  const auto file = tremolo::testing::reference_folder() / "waves" / c.file;
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto rows = tremolo::testing::read_table(file);
  const auto coarse = errors(c, rows, c.element, c.step);
  const auto fine = errors(c, rows, 0.5 * c.element, 0.5 * c.step);
  for (std::size_t q = 0; q < names.size(); ++q) {
    const double order = std::log2(coarse[q] / fine[q]);
    std::printf("%-4s %.2e %.2e order %.2f\n", names[q], coarse[q], fine[q], order);
    EXPECT_GT(order, 1.8) << names[q];
    EXPECT_LT(fine[q], c.largest_error) << names[q];
  }
}

INSTANTIATE_TEST_SUITE_P(, MarchedInHalfSpace,
                         testing::Values(half_space("halfspace_SV_15deg.csv", true, 15.0),
                                         half_space("halfspace_P_30deg.csv", false, 30.0)));

} // namespace
