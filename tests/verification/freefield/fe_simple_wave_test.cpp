// A soft half-space sheared monotonically at its face: the exact simple wave of the reference data, v
// constant on straight characteristics that fan out as the soil softens. The face is the rigid base of a
// column so tall that its surface stays unknown to the levels that are looked at. Perfectly plastic soil
// carries no more than its strength, hence no particle velocity above strength over impedance.

#include "freefield/twophase/two_phase_column.hpp"
#include "tests/support/reference_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;
using tremolo::materials::MohrCoulomb;

constexpr double density = 1800.0;
constexpr double shear_speed = 200.0;
// Poisson's ratio 0: the vertical wave, which is idle here, then limits an explicit step least.
const Elasticity soil = Elasticity::from_wave_speeds(density, shear_speed, std::numbers::sqrt2* shear_speed);
constexpr double height = 60.0;
constexpr double end = 0.49; ///< s; the reflection from the surface reaches 20 m at 0.5 s

Profile half_space_of(const tremolo::materials::Law& law) {
  return {.surface_level = height, .layers = {layer_of(height, law)}, .half_space = soil};
}

InputVelocity smooth_rise(double velocity) {
  return [=](double t) {
    const double share = t <= 0.0 ? 0.0 : t >= 0.2 ? 1.0 : 0.5 * (1.0 - std::cos(std::numbers::pi * t / 0.2));
    return Velocity{velocity * share, 0.0};
  };
}

/// The acceleration's rate jumps at the wave's front, which arrives with the speed of unloaded soil; no
/// scheme is of order two there. This much time around it is left out, s.
constexpr double front = 0.01;

/// Root-mean-square errors of velocity, strain and stress at 5, 10 and 20 m, relative to their peaks.
std::array<double, 3> errors(const std::vector<std::vector<double>>& rows, const tremolo::materials::Law& law,
                             double face_velocity, double size) {
  const double dt = 0.5 * size / shear_speed;
  const TwoPhaseSettings settings{.max_element_size = size, .time_step = dt, .base = BaseKind::rigid};
  TwoPhaseColumn column(half_space_of(law), settings, smooth_rise(face_velocity));
  constexpr std::array<double, 3> levels = {5.0, 10.0, 20.0};
  std::array<ColumnSample, 3> samples;
  std::array<double, 3> squares{};
  int count = 0;
  std::array<double, 3> peak{};
  for (const auto& row : rows) {
    if (row[0] > end) {
      break;
    }
    while (column.time() < row[0] - 0.5 * dt) {
      column.step();
    }
    column.sample(levels, samples);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      if (std::abs(row[0] - levels[level] / shear_speed) < front) {
        continue;
      }
      ++count;
      const ColumnSample& s = samples[level];
      const std::array<double, 3> computed = {s.vx, -s.gxy, -s.sxy};
      for (std::size_t q = 0; q < 3; ++q) {
        const double expected = row[4 + 3 * level + q];
        squares[q] += std::pow(computed[q] - expected, 2);
        peak[q] = std::max(peak[q], std::abs(expected));
      }
    }
  }
  return {std::sqrt(squares[0] / count) / peak[0], std::sqrt(squares[1] / count) / peak[1],
          std::sqrt(squares[2] / count) / peak[2]};
}

class SimpleWave : public ::testing::Test {
protected:
  void expect_second_order(const std::string& name, const MasingShear& law, double face_velocity,
                           double largest_error) {
    const auto file = tremolo::testing::reference_folder() / "waves" / name;
    if (!std::filesystem::exists(file)) {
      GTEST_SKIP() << "no reference data at " << file;
    }
    const auto rows = tremolo::testing::read_table(file);
    const auto coarse = errors(rows, law, face_velocity, 0.2);
    const auto fine = errors(rows, law, face_velocity, 0.1);
    constexpr std::array<const char*, 3> names = {"velocity", "strain", "stress"};
    for (std::size_t q = 0; q < 3; ++q) {
      const double order = std::log2(coarse[q] / fine[q]);
      std::printf("%-8s %.2e %.2e order %.2f\n", names[q], coarse[q], fine[q], order);
      EXPECT_GT(order, 1.8) << names[q];
      EXPECT_LT(fine[q], largest_error) << names[q];
    }
  }
};

TEST_F(SimpleWave, HyperbolicSoilConvergesAtOrderTwo) {
  expect_second_order("nonlinear_simple_wave.csv", {.elastic = soil, .reference_strain = 1e-3}, 0.8, 1e-3);
}

TEST_F(SimpleWave, MkzSoilConvergesAtOrderTwo) {
  expect_second_order("nonlinear_simple_wave_mkz.csv",
                      {.elastic = soil, .reference_strain = 1e-3, .exponent = 0.919}, 0.5, 1e-3);
}

// Cohesive soil without friction, tau_y = 20 kPa: the face moves at three times the velocity that the soil
// can pass on. Behind the elastic front everything beyond the first element moves at tau_y/(rho Vs) exactly.
TEST(PerfectlyPlasticSoil, PassesOnNoMoreVelocityThanStrengthOverImpedance) {
  const double strength = 20e3;
  const double cap = strength / (density * shear_speed);
  const MohrCoulomb clay{.elastic = soil, .cohesion_peak = strength, .cohesion_residual = strength};
  const TwoPhaseSettings settings{.max_element_size = 0.25, .time_step = 6e-4, .base = BaseKind::rigid};
  TwoPhaseColumn column(half_space_of(clay), settings, smooth_rise(3.0 * cap));
  const std::array<double, 2> levels = {5.0, 10.0};
  std::array<ColumnSample, 2> samples;
  double largest = 0.0;
  while (column.time() < 0.4) {
    column.step();
    column.sample(levels, samples);
    largest = std::max({largest, samples[0].vx, samples[1].vx});
  }
  EXPECT_NEAR(largest, cap, 5e-3 * cap);
  for (const ColumnSample& s : samples) {
    EXPECT_NEAR(s.vx, cap, 2e-3 * cap);
    EXPECT_NEAR(s.sxy, -strength, 2e-3 * strength);
  }
}

} // namespace
