// The marched column against the exact field of the frequency domain, in three elastic layers with a soft one
// in the middle: two methods that share nothing but the equations of motion.

#include "freefield/marched/marched_column.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo;
using freefield::ColumnSample;
using freefield::MarchedColumn;
using materials::Elasticity;
using wavefield::LayeredField;
using wavefield::WaveType;

constexpr double interval = 0.01;
constexpr std::size_t intervals = 250;
constexpr std::array<double, 6> levels = {0.0, -2.3, -7.0, -11.9, -15.0, -25.0}; // the base is at -25 m
constexpr std::array<const char*, 7> names = {"ux", "uy", "vx", "vy", "sxx", "syy", "sxy"};
using Values = std::array<double, names.size()>;

freefield::Profile inverted() {
  return {.layers = {{5.0, Elasticity::from_wave_speeds(1900.0, 250.0, 520.0)},
                     {8.0, Elasticity::from_wave_speeds(1650.0, 120.0, 300.0)},
                     {12.0, Elasticity::from_wave_speeds(1950.0, 300.0, 600.0)}},
          .half_space = Elasticity::from_wave_speeds(2200.0, 500.0, 1000.0)};
}

wavefield::LayeredHalfSpace as_wavefield(const freefield::Profile& profile) {
  const Elasticity& base = profile.half_space;
  wavefield::LayeredHalfSpace layered{
      .half_space = {.density = base.density, .vs = base.s_wave_speed(), .vp = base.p_wave_speed()}};
  for (const freefield::Layer& layer : profile.layers) {
    layered.layers.push_back({.thickness = layer.thickness,
                              .density = layer.soil.density,
                              .vs = layer.soil.s_wave_speed(),
                              .vp = layer.soil.p_wave_speed()});
  }
  return layered;
}

struct Wave {
  WaveType type;
  double angle_deg;
  double angle() const { return angle_deg * std::numbers::pi / 180.0; }
};

void PrintTo(const Wave& wave, std::ostream* out) {
  *out << (wave.type == WaveType::SV ? "SV " : "P ") << wave.angle_deg;
}

/// Largest errors over levels and times, relative to the peaks.
Values errors(const Wave& wave, double cell) {
  const auto profile = inverted();
  // So small that elements keep their length.
  const wavefield::Signal signal = wavefield::ricker(3.0, 1.0, 1e-5);
  const LayeredField field(as_wavefield(profile), {wave.type, wave.angle(), 0.0, profile.base_level()}, 0.0,
                           signal);
  std::vector<wavefield::Point> points;
  for (const double y : levels) {
    points.push_back({.x = 0.0, .y = y});
  }
  const auto exact = field.sample(points, {interval, interval, intervals});

  const double p = field.slowness_x();
  const double limit = freefield::marched_step_limit(profile, cell, p, {});
  const double steps = std::ceil(interval / (0.9 * limit));
  MarchedColumn column(profile, {.max_element_size = cell, .time_step = interval / steps, .slowness_x = p},
                       [&](double t) {
                         const double v = t < signal.begin || t > signal.end ? 0.0 : signal.velocity(t);
                         const double along = v * std::cos(wave.angle()), across = v * std::sin(wave.angle());
                         return wave.type == WaveType::SV ? freefield::Velocity{along, -across}
                                                          : freefield::Velocity{across, along};
                       });
  Values error{}, peak{};
  std::array<ColumnSample, levels.size()> samples;
  for (std::size_t i = 0; i < intervals; ++i) {
    for (int k = 0; k < static_cast<int>(steps); ++k) {
      column.step();
    }
    column.sample(levels, samples);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      const ColumnSample& s = samples[level];
      const wavefield::History& h = exact[level];
      const Values computed = {s.ux, s.uy, s.vx, s.vy, s.sxx, s.syy, s.sxy};
      const Values expected = {h.ux[i], h.uy[i], h.vx[i], h.vy[i], h.sxx[i], h.syy[i], h.sxy[i]};
      for (std::size_t q = 0; q < names.size(); ++q) {
        error[q] = std::max(error[q], std::abs(computed[q] - expected[q]));
        peak[q] = std::max(peak[q], std::abs(expected[q]));
      }
    }
  }
  for (std::size_t q = 0; q < names.size(); ++q) {
    error[q] /= peak[q];
  }
  return error;
}

class MarchedAgainstWavefield : public testing::TestWithParam<Wave> {};

TEST_P(MarchedAgainstWavefield, SecondOrderWithASoftLayerInTheMiddle) {
  const Values coarse = errors(GetParam(), 0.5);
  const Values fine = errors(GetParam(), 0.125); // two halvings: where a level lies in its cell changes too
  for (std::size_t q = 0; q < names.size(); ++q) {
    const double order = 0.5 * std::log2(coarse[q] / fine[q]);
    std::printf("%-4s %.2e %.2e order %.2f\n", names[q], coarse[q], fine[q], order);
    EXPECT_GT(order, 1.9) << names[q];
    EXPECT_LT(fine[q], 5e-4) << names[q];
  }
}

INSTANTIATE_TEST_SUITE_P(, MarchedAgainstWavefield,
                         testing::Values(Wave{WaveType::SV, 20.0}, Wave{WaveType::P, 30.0}));

} // namespace
