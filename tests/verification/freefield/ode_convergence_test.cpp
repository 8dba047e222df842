// Order of the column by the method of lines against the exact response of two damped layers on an
// elastic half-space to a pulse in both polarisations: velocity, stress and their rates, on nodes, between
// them, at the interface and at the base.

#include "freefield/ode/ode_column.hpp"
#include "tests/support/layered_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using Exact = tremolo::testing::LayeredColumn;

constexpr double pulse_frequency = 3.0, pulse_time = 0.5, interval = 0.02;
constexpr std::size_t intervals = 90;
constexpr std::array<double, 7> depths = {0.0, 0.3, 3.0, 8.0, 15.2, 29.7, 30.0};

double pulse(double t) {
  const double a = std::pow(std::numbers::pi * pulse_frequency * (t - pulse_time), 2);
  return (1.0 - 2.0 * a) * std::exp(-a);
}

Profile two_layers() {
  return {.layers = {{8.0, Elasticity::from_wave_speeds(1700.0, 150.0, 320.0), 0.03},
                     {22.0, Elasticity::from_wave_speeds(1900.0, 300.0, 560.0), 0.01}},
          .half_space = Elasticity::from_wave_speeds(2200.0, 800.0, 1500.0)};
}

/// Of one polarisation, of which `modulus` is the modulus.
Exact exact(const Profile& profile, const Damping& damping, double (Elasticity::*modulus)() const) {
  std::vector<tremolo::testing::ScalarLayer> layers;
  for (const Layer& layer : profile.layers) {
    const DampingCoefficients c = coefficients(damping, layer.damping_ratio);
    layers.push_back({layer.thickness, layer.soil.density, (layer.soil.*modulus)(), c.alpha, c.beta});
  }
  const Elasticity& base = profile.half_space;
  return {layers, std::sqrt(base.density * (base.*modulus)()), pulse_frequency, pulse_time};
}

constexpr std::array<const char*, 8> names = {"vx", "sxy", "vx rate", "sxy rate",
                                              "vy", "syy", "vy rate", "syy rate"};
using Values = std::array<double, names.size()>;

/// Histories at each of the depths.
std::array<std::vector<Values>, depths.size()> exact_histories(const Profile& profile,
                                                               const Damping& damping) {
  std::vector<double> times;
  for (std::size_t i = 1; i <= intervals; ++i) {
    times.push_back(interval * static_cast<double>(i));
  }
  const Exact shear = exact(profile, damping, &Elasticity::shear_modulus);
  const Exact dilation = exact(profile, damping, &Elasticity::p_modulus);
  std::array<std::vector<Values>, depths.size()> histories;
  for (std::size_t d = 0; d < depths.size(); ++d) {
    const auto x = shear.at(depths[d], times);
    const auto y = dilation.at(depths[d], times);
    for (std::size_t i = 0; i < times.size(); ++i) {
      histories[d].push_back({x[i].velocity, x[i].stress, x[i].acceleration, x[i].stress_rate, y[i].velocity,
                              y[i].stress, y[i].acceleration, y[i].stress_rate});
    }
  }
  return histories;
}

/// Largest errors over depths and times, relative to the peaks.
Values errors(const Profile& profile, const Damping& damping,
              const std::array<std::vector<Values>, depths.size()>& expected, double cell) {
  OdeColumnSettings settings;
  settings.max_cell_size = cell;
  settings.time_step = interval;
  settings.method = OdeMethod::bdf;
  settings.relative_tolerance = 1e-8;
  settings.absolute_tolerance = 1e-9;
  settings.damping = damping;
  OdeColumn column(profile, settings, [](double t) { return Velocity{pulse(t), pulse(t)}; });
  std::array<double, depths.size()> levels{};
  std::transform(depths.begin(), depths.end(), levels.begin(), [](double depth) { return -depth; });
  std::array<ColumnSample, depths.size()> samples;
  Values error{}, peak{};
  for (std::size_t i = 0; i < intervals; ++i) {
    column.step();
    column.sample(levels, samples);
    for (std::size_t d = 0; d < depths.size(); ++d) {
      const ColumnSample& s = samples[d];
      const Values computed = {s.vx, s.sxy, s.vx_rate, s.sxy_rate, s.vy, s.syy, s.vy_rate, s.syy_rate};
      for (std::size_t q = 0; q < names.size(); ++q) {
        error[q] = std::max(error[q], std::abs(computed[q] - expected[d][i][q]));
        peak[q] = std::max(peak[q], std::abs(expected[d][i][q]));
      }
    }
  }
  for (std::size_t q = 0; q < names.size(); ++q) {
    error[q] /= peak[q];
  }
  return error;
}

constexpr std::size_t of_shear = 4; // how many of the names

/// @param ordered  of how many names the order is asked
void expect_second_order(const Damping& damping, std::size_t ordered) {
  const Profile profile = two_layers();
  const auto expected = exact_histories(profile, damping);
  const Values coarse = errors(profile, damping, expected, 0.5);
  const Values fine = errors(profile, damping, expected, 0.25);
  for (std::size_t q = 0; q < names.size(); ++q) {
    const double order = std::log2(coarse[q] / fine[q]);
    std::printf("%-9s %.2e %.2e order %.2f\n", names[q], coarse[q], fine[q], order);
    if (q < ordered) {
      EXPECT_GT(order, 1.9) << names[q];
    }
    EXPECT_LT(fine[q], q < of_shear ? 2e-3 : 2e-4) << names[q];
  }
}

TEST(OdeColumnConvergence, SecondOrderInTwoKelvinVoigtLayersRatesIncluded) {
  expect_second_order(KelvinVoigtDamping{3.0}, names.size());
}

TEST(OdeColumnConvergence, SecondOrderInTwoRayleighLayersRatesIncluded) {
  expect_second_order(RayleighDamping{1.0, 6.0},
                      1.0); // in smaller cells P waves err by 2e-5, and by time as well
}

} // namespace
