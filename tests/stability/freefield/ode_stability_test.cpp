// Hard cases of the column by the method of lines: stiff damping, no damping for long, large strain, soft
// soil on rock, nearly incompressible soil, and what it refuses.

#include "freefield/ode/ode_column.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;

InputVelocity pulse(double velocity, double frequency) {
  return [=](double t) {
    const double a = std::pow(std::numbers::pi * frequency * (t - 1.5 / frequency), 2);
    return Velocity{velocity * (1.0 - 2.0 * a) * std::exp(-a),
                    0.5 * velocity * (1.0 - 2.0 * a) * std::exp(-a)};
  };
}

OdeColumnSettings settings_of(OdeMethod method, double cell, double interval = 0.01) {
  OdeColumnSettings settings;
  settings.max_cell_size = cell;
  settings.time_step = interval;
  settings.method = method;
  settings.absolute_tolerance = 1e-7;
  return settings;
}

/// Largest velocities and shear strain at levels from top to base over a number of intervals.
struct Peaks {
  double vx = 0.0, vy = 0.0, strain = 0.0;
};
Peaks march(OdeColumn& column, int intervals, int looked_at_each = 1) {
  Peaks peaks;
  for (int i = 0; i < intervals; ++i) {
    column.step();
    if (i % looked_at_each != 0) {
      continue;
    }
    std::array<double, 5> levels{};
    for (std::size_t k = 0; k < levels.size(); ++k) {
      levels[k] = std::lerp(column.surface_level(), column.base_level(), 0.25 * static_cast<double>(k));
    }
    std::array<ColumnSample, 5> samples;
    column.sample(levels, samples);
    for (const ColumnSample& s : samples) {
      peaks.vx = std::max(peaks.vx, std::abs(s.vx));
      peaks.vy = std::max(peaks.vy, std::abs(s.vy));
      peaks.strain = std::max(peaks.strain, std::abs(s.gxy));
    }
  }
  return peaks;
}

// 10 % damping at 1 Hz in cells of 0.25 m: beta = 0.032 s, rate of the stiffest mode beta (2c/h)^2 = 8e4 1/s.
TEST(OdeColumnStability, StiffDampingNeedsAnImplicitMethod) {
  const Profile profile{.layers = {{20.0, Elasticity::from_wave_speeds(1800.0, 200.0, 400.0), 0.1}},
                        .half_space = Elasticity::from_wave_speeds(2200.0, 800.0, 1600.0)};
  std::array<long, 4> steps{};
  std::array<double, 4> peak{};
  for (const OdeMethod method : {OdeMethod::bdf, OdeMethod::imex, OdeMethod::explicit_runge_kutta}) {
    auto settings = settings_of(method, 0.25);
    settings.damping = KelvinVoigtDamping{1.0};
    OdeColumn column(profile, settings, pulse(0.1, 2.0));
    const auto i = static_cast<std::size_t>(method);
    peak[i] = march(column, 100).vx;
    const auto s = column.statistics();
    steps[i] = s.steps;
    std::printf("method %zu: %ld steps, %ld rejections, %ld right-hand sides, %ld jacobians\n", i, s.steps,
                s.rejections, s.right_hand_sides, s.jacobians);
  }
  const auto bdf = static_cast<std::size_t>(OdeMethod::bdf), imex = static_cast<std::size_t>(OdeMethod::imex);
  const auto erk = static_cast<std::size_t>(OdeMethod::explicit_runge_kutta);
  EXPECT_LT(steps[bdf], 2000);
  EXPECT_LT(steps[imex], 4000);
  EXPECT_GT(steps[erk], 20 * steps[bdf]);
  EXPECT_NEAR(peak[bdf], peak[erk], 1e-3 * peak[erk]);
  EXPECT_NEAR(peak[imex], peak[erk], 1e-3 * peak[erk]);
}

// 200 s, some 700 periods. No method conserves energy: Runge-Kutta loses some, Adams gains in proportion to
// the tolerance.
TEST(OdeColumnStability, UndampedColumnStaysBoundedForAHundredThousandIntervals) {
  const auto soil = Elasticity::from_wave_speeds(1800.0, 200.0, 400.0);
  const auto growth = [&](OdeMethod method, double tolerance) {
    auto settings = settings_of(method, 5.0, 2e-3);
    settings.base = BaseKind::rigid;
    settings.relative_tolerance = tolerance;
    settings.absolute_tolerance = 0.1 * tolerance;
    OdeColumn column({.layers = {{20.0, soil}}, .half_space = soil}, settings,
                     [shear = pulse(0.1, 2.5)](double t) {
                       return Velocity{shear(t).x, 0.0};
                     });
    const double early = march(column, 4'000, 4).vx;
    const double late = march(column, 96'000, 4).vx;
    std::printf("method %d at %.0e: %.3e then %.3e m/s, %ld steps\n", static_cast<int>(method), tolerance,
                early, late, column.statistics().steps);
    return late / early;
  };
  EXPECT_LT(growth(OdeMethod::explicit_runge_kutta, 1e-5), 1.001);
  const double loose = growth(OdeMethod::adams, 1e-5);
  const double tight = growth(OdeMethod::adams, 1e-7);
  EXPECT_LT(loose, 1.1);
  EXPECT_LT(tight, 1.002);
}

TEST(OdeColumnStability, FivePerCentStrainInSoftClayOnRock) {
  const auto clay = Elasticity::from_wave_speeds(1500.0, 30.0, 1450.0); // Poisson's ratio 0.4998
  for (const OdeMethod method :
       {OdeMethod::adams, OdeMethod::bdf, OdeMethod::explicit_runge_kutta, OdeMethod::imex}) {
    const Profile profile{.layers = {layer_of(10.0, MasingShear{clay, 2e-3, 1.0, 0.9})},
                          .half_space = Elasticity::from_wave_speeds(2600.0, 2500.0, 4500.0)};
    OdeColumn column(profile, settings_of(method, 0.5), pulse(0.2, 1.0));
    const Peaks peaks = march(column, 400);
    std::printf("method %d: strain %.3f, %.3f m/s, %ld steps\n", static_cast<int>(method), peaks.strain,
                peaks.vx, column.statistics().steps);
    EXPECT_GT(peaks.strain, 0.05);
    EXPECT_LT(peaks.vx, 1.0);
    EXPECT_LT(peaks.vy, 0.4); // 4 x 0.5 x 0.2: twice at the free surface, up to twice by soft over stiff
  }
}

TEST(OdeColumnStability, PoissonRatioNearOneHalf) {
  const Elasticity soil{1800.0, 2.0 * 1.499 * 1800.0 * 150.0 * 150.0, 0.499};
  OdeColumn column(
      {.layers = {{20.0, soil, 0.02}}, .half_space = Elasticity::from_wave_speeds(2200.0, 800.0, 2400.0)},
      [] {
        auto settings = settings_of(OdeMethod::bdf, 0.5);
        settings.damping = RayleighDamping{1.0, 10.0};
        return settings;
      }(),
      pulse(0.1, 2.0));
  const Peaks peaks = march(column, 300);
  EXPECT_LT(peaks.vx, 0.5);
  EXPECT_LT(peaks.vy, 0.3);
  EXPECT_GT(peaks.vy, 0.05);
}

} // namespace
