// Hard cases of the marched column: soft layers that trap waves, an angle close to the limit, large strain.

#include "freefield/marched/marched_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;

constexpr double degree = std::numbers::pi / 180.0;

InputVelocity pulse(double velocity, double angle) {
  return [=](double t) {
    const double a = std::pow(std::numbers::pi * 3.0 * (t - 0.5), 2);
    const double v = velocity * (1.0 - 2.0 * a) * std::exp(-a);
    return Velocity{v * std::cos(angle), -v * std::sin(angle)};
  };
}

struct Peaks {
  double velocity = 0.0, strain = 0.0;
};
Peaks march(MarchedColumn& column, long steps) {
  std::array<double, 9> levels{};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels[i] = std::lerp(column.surface_level(), column.base_level(), static_cast<double>(i) / 8.0);
  }
  std::array<ColumnSample, 9> samples;
  Peaks peaks;
  for (long i = 0; i < steps; ++i) {
    column.step();
    column.sample(levels, samples);
    for (const ColumnSample& s : samples) {
      peaks.velocity = std::max({peaks.velocity, std::abs(s.vx), std::abs(s.vy)});
      peaks.strain = std::max(peaks.strain, std::abs(s.gxy));
    }
  }
  return peaks;
}

// Soft layers on stiff rock trap the waves; what the half-space takes is all that is lost.
TEST(MarchedHardCases, UndampedLayersOnRockOnlyLoseEnergyInAHundredThousandSteps) {
  const Profile profile{.layers = {{5.0, Elasticity::from_wave_speeds(1600.0, 100.0, 200.0)},
                                   {10.0, Elasticity::from_wave_speeds(1800.0, 200.0, 400.0)}},
                        .half_space = Elasticity::from_wave_speeds(2600.0, 2000.0, 4000.0)};
  const double p = std::sin(25.0 * degree) / 2000.0;
  const double dt = 0.99 * marched_step_limit(profile, 0.5, p, {});
  MarchedColumn column(profile, {.max_element_size = 0.5, .time_step = dt, .slowness_x = p},
                       pulse(0.1, 25.0 * degree));
  double before = march(column, 20'000).velocity;
  EXPECT_LT(before, 2.0);
  for (int i = 0; i < 8; ++i) {
    const double now = march(column, 10'000).velocity;
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(MarchedHardCases, OneDegreeBelowTheLimitIsStableWithASmallStep) {
  const auto soil = Elasticity::from_wave_speeds(1800.0, 200.0, 400.0); // limit 30 degrees
  const Profile profile{.layers = {{20.0, soil}}, .half_space = soil};
  const double p = std::sin(29.0 * degree) / 200.0;
  const double limit = marched_step_limit(profile, 0.5, p, {});
  std::printf("step limit %.3e s, vertically %.3e s\n", limit, marched_step_limit(profile, 0.5, 0.0, {}));
  EXPECT_LT(limit, 0.26 * marched_step_limit(profile, 0.5, 0.0, {})); // sqrt(1 - (sin 29 / sin 30)^2) = 0.245
  MarchedColumn column(profile, {.max_element_size = 0.5, .time_step = 0.95 * limit, .slowness_x = p},
                       pulse(0.1, 29.0 * degree));
  const double pulse_peak = march(column, static_cast<long>(2.0 / column.time_step())).velocity;
  EXPECT_GT(pulse_peak, 0.1);
  EXPECT_LT(pulse_peak, 0.6);
  EXPECT_LT(march(column, 20'000).velocity, 0.05 * pulse_peak);
}

TEST(MarchedHardCases, FivePerCentOfStrain) {
  const Profile profile{
      .layers = {layer_of(8.0,
                          MasingShear{Elasticity::from_wave_speeds(1600.0, 60.0, 120.0), 1e-3, 1.0, 0.919}),
                 {12.0, Elasticity::from_wave_speeds(1900.0, 250.0, 500.0)}},
      .half_space = Elasticity::from_wave_speeds(2300.0, 700.0, 1400.0)};
  const double p = std::sin(28.0 * degree) / 700.0;
  MarchedColumn column(profile,
                       {.max_element_size = 0.25,
                        .time_step = 0.9 * marched_step_limit(profile, 0.25, p, {}),
                        .slowness_x = p},
                       pulse(1.5, 28.0 * degree));
  const Peaks peaks = march(column, 20'000);
  std::printf("strain %.3f, velocity %.2f m/s\n", peaks.strain, peaks.velocity);
  EXPECT_GT(peaks.strain, 0.05);
  EXPECT_LT(peaks.velocity, 15.0);
  EXPECT_LT(march(column, 20'000).velocity, peaks.velocity);
}

} // namespace
