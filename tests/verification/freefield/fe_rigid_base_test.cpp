// A Kelvin-Voigt layer on a rigid base that moves as prescribed. Per frequency the motion at height z above
// the base is cos(k*(H - z))/cos(k*H) times that of the base, k* = w sqrt(rho/(G (1 + i w beta))).

#include "freefield/twophase/two_phase_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::LinearElastic;

constexpr double height = 20.0;
constexpr double pulse_frequency = 4.0;
constexpr double pulse_time = 0.4;
constexpr double damping_frequency = 3.0;
constexpr double damping_ratio = 0.05;
/// Peak velocity of the pulse, m/s. It is so small that elements hardly change their length, which the closed
/// form keeps.
constexpr double amplitude = 1e-4;
const Elasticity soil = Elasticity::from_wave_speeds(2000.0, 300.0, 700.0);

double pulse(double t) {
  const double a = std::pow(std::numbers::pi * pulse_frequency * (t - pulse_time), 2);
  return (1.0 - 2.0 * a) * std::exp(-a);
}

struct Exact {
  double velocity = 0.0, displacement = 0.0, strain = 0.0;
};

/// Fourier sum over a period in which the response dies out.
Exact exact(double speed, double z, double time) {
  constexpr double period = 20.0;
  const double beta = damping_ratio / (std::numbers::pi * damping_frequency);
  Exact sum;
  for (int n = 1; n < static_cast<int>(8.0 * pulse_frequency * period); ++n) {
    const double f = n / period;
    const double w = 2.0 * std::numbers::pi * f;
    const double ratio = f / pulse_frequency;
    const double spectrum =
        2.0 / std::sqrt(std::numbers::pi) * ratio * ratio * std::exp(-ratio * ratio) / pulse_frequency;
    const std::complex<double> k = w / speed / std::sqrt(std::complex<double>(1.0, w * beta));
    const auto wave = std::polar(2.0 / period * spectrum, w * (time - pulse_time));
    const auto base = std::cos(k * height);
    const std::complex<double> iw(0.0, w);
    sum.velocity += (wave * std::cos(k * (height - z)) / base).real();
    sum.displacement += (wave / iw * std::cos(k * (height - z)) / base).real();
    sum.strain += (wave / iw * k * std::sin(k * (height - z)) / base).real();
  }
  return sum;
}

/// Largest errors of velocity, displacement and strain of both components, relative to the peaks.
std::array<double, 3> errors(double size, double dt, bool with_law) {
  const Layer layer =
      with_law ? layer_of(height, LinearElastic{soil}, damping_ratio) : Layer{height, soil, damping_ratio};
  const TwoPhaseSettings settings{.max_element_size = size,
                                  .time_step = dt,
                                  .damping = KelvinVoigtDamping{damping_frequency},
                                  .base = BaseKind::rigid};
  TwoPhaseColumn column({.layers = {layer}, .half_space = soil}, settings, [](double t) {
    return Velocity{amplitude * pulse(t), 0.5 * amplitude * pulse(t)};
  });
  constexpr std::array<double, 4> heights = {0.0, 7.3, 15.0, 20.0};
  std::array<double, 4> levels;
  std::transform(heights.begin(), heights.end(), levels.begin(), [](double z) { return z - height; });
  std::array<ColumnSample, 4> samples;
  std::array<double, 3> error{};
  std::array<double, 3> peak{};
  for (int i = 1; i <= 30; ++i) {
    const double time = 0.05 * i;
    while (column.time() < time - 0.5 * dt) {
      column.step();
    }
    column.sample(levels, samples);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      const ColumnSample& s = samples[level];
      const Exact x = exact(soil.s_wave_speed(), heights[level], time);
      const Exact y = exact(soil.p_wave_speed(), heights[level], time);
      const std::array<double, 6> computed = {s.vx, s.ux, s.gxy, 2.0 * s.vy, 2.0 * s.uy, 2.0 * s.eyy};
      const std::array<double, 6> expected = {x.velocity, x.displacement, x.strain,
                                              y.velocity, y.displacement, y.strain};
      for (std::size_t q = 0; q < 6; ++q) {
        error[q % 3] = std::max(error[q % 3], std::abs(computed[q] / amplitude - expected[q]));
        peak[q % 3] = std::max(peak[q % 3], std::abs(expected[q]));
      }
    }
  }
  return {error[0] / peak[0], error[1] / peak[1], error[2] / peak[2]};
}

class RigidBase : public ::testing::TestWithParam<bool> {};

TEST_P(RigidBase, FollowsTheTransferFunctionAtOrderTwo) {
  constexpr double dt = 8e-5; // damping limits the step to 4.8e-5 s on the finer mesh
  const auto coarse = errors(1.0, dt, GetParam());
  const auto fine = errors(0.5, dt / 2.0, GetParam());
  for (std::size_t q = 0; q < 3; ++q) {
    std::printf("%.2e %.2e order %.2f\n", coarse[q], fine[q], std::log2(coarse[q] / fine[q]));
    EXPECT_GT(std::log2(coarse[q] / fine[q]), 1.8);
    EXPECT_LT(fine[q], 5e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutALaw, RigidBase, ::testing::Bool());

} // namespace
