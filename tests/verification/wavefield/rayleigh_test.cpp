// Rayleigh damping of plane waves at vertical incidence against a second method: layers of scalar waves by
// sines and cosines of the whole column, summed frequency by frequency (tests/support/layered_column.hpp).

#include "tests/support/layered_column.hpp"
#include "wavefield/layers/layered_field.hpp"
#include "wavefield/layers/transfer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::wavefield;
using tremolo::testing::LayeredColumn;
using tremolo::testing::ScalarLayer;

constexpr double frequency = 3.0;
constexpr double time = 0.5;

LayeredHalfSpace ground(std::vector<Layer> layers) {
  return {.layers = std::move(layers),
          .half_space = {2200.0, 800.0, 1500.0},
          .damping = {.model = DampingModel::rayleigh, .frequencies_hz = {1.0, 6.0}}};
}

/// Two soils of 3 and 1 %.
LayeredHalfSpace two_layers() {
  return ground({{8.0, 1700.0, 150.0, 320.0, 0.03}, {22.0, 1900.0, 300.0, 560.0, 0.01}});
}

/// The same with rock below that has no damping: the reference motion is that at its top.
LayeredHalfSpace rock_below() {
  auto profile = two_layers();
  profile.layers[1].thickness = 10.0;
  profile.layers.push_back({12.0, 2200.0, 800.0, 1500.0, 0.0});
  return profile;
}

LayeredColumn exact(const LayeredHalfSpace& profile, WaveType wave) {
  const auto speed = wave == WaveType::SV ? &Layer::vs : &Layer::vp;
  std::vector<ScalarLayer> layers;
  for (const Layer& layer : profile.layers) {
    const auto [alpha, beta] = rayleigh_factors(profile.damping, layer.damping);
    layers.push_back(
        {layer.thickness, layer.density, layer.density * std::pow(layer.*speed, 2), alpha, beta});
  }
  const HalfSpace& rock = profile.half_space;
  return {layers, rock.density * (wave == WaveType::SV ? rock.vs : rock.vp), frequency, time};
}

TEST(RayleighWaves, FactorsGiveTheRatioAtBothFrequencies) {
  const auto [alpha, beta] =
      rayleigh_factors({.model = DampingModel::rayleigh, .frequencies_hz = {1.0, 6.0}}, 0.03);
  for (const double f : {1.0, 6.0}) {
    const double w = 2.0 * std::numbers::pi * f;
    EXPECT_NEAR(alpha / (2.0 * w) + beta * w / 2.0, 0.03, 1e-15);
  }
}

TEST(RayleighWaves, AreThoseOfTheExactColumn) {
  const std::array<double, 6> depths{0.0, 3.0, 7.9, 8.1, 15.2, 29.9};
  for (const auto& profile : {two_layers(), rock_below()})
    for (const WaveType wave : {WaveType::SV, WaveType::P}) {
      const Incidence incidence{wave, 0.0, 0.0, -profile.thickness()};
      const LayeredField field(profile, incidence, 0.0, ricker(frequency, time, 1.0));
      std::vector<Point> points;
      for (const double depth : depths)
        points.push_back({0.0, -depth});
      const TimeGrid grid{0.0, 0.02, 150};
      std::vector<double> times;
      for (std::size_t i = 0; i < grid.count; ++i)
        times.push_back(grid.start + grid.dt * static_cast<double>(i));
      const auto histories = field.sample(points, grid);
      const auto column = exact(profile, wave);
      for (std::size_t d = 0; d < depths.size(); ++d) {
        const auto expected = column.at(depths[d], times);
        double velocity = 0.0, stress = 0.0, largest = 0.0;
        for (std::size_t i = 0; i < times.size(); ++i) {
          const auto& history = histories[d];
          velocity = std::max(
              velocity, std::abs((wave == WaveType::SV ? history.vx : history.vy)[i] - expected[i].velocity));
          stress = std::max(
              stress, std::abs((wave == WaveType::SV ? history.sxy : history.syy)[i] - expected[i].stress));
          largest = std::max(largest, std::abs(expected[i].velocity));
        }
        EXPECT_LT(velocity, 1e-7 * largest) << depths[d];
        EXPECT_LT(stress, 1e-7 * largest * 2200.0 * 1500.0) << depths[d];
      }
    }
}

TEST(RayleighWaves, DoNotBrakeGroundThatMovesAsOne) {
  // So slow that the layers do not bend, and that mass-proportional damping would take all of it.
  const auto found = transfer(two_layers(), WaveType::SV, 0.0, std::array{1e-4}, std::array{0.0, 10.0, 30.0});
  for (const Amplitude& amplitude : found.front())
    EXPECT_NEAR(std::abs(amplitude.ux), 2.0, 1e-4);
}

TEST(RayleighWaves, AreRefusedAtAnAngleAndOnDampedRock) {
  const Signal signal = ricker(frequency, time, 1.0);
  const TimeGrid grid{0.0, 0.02, 10};
  const std::array<Point, 1> surface{Point{0.0, 0.0}};
  const auto sample = [&](const LayeredHalfSpace& profile, double angle) {
    LayeredField(profile, {WaveType::SV, angle, 0.0, -30.0}, 0.0, signal).sample(surface, grid);
  };
  EXPECT_NO_THROW(sample(two_layers(), 0.0));
  EXPECT_THROW(sample(two_layers(), 0.1), std::invalid_argument);
  auto damped = two_layers();
  damped.half_space_damping = 0.01;
  EXPECT_THROW(sample(damped, 0.0), std::invalid_argument);
}

} // namespace
