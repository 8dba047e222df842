#include "tests/support/layered_reference.hpp"
#include "wavefield/layers/layered_field.hpp"
#include "wavefield/signal/window.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace tremolo::wavefield;
using tremolo::testing::layered3;
using tremolo::testing::radians;

TEST(Window, HoldsGridAndSignalOnItsOwnSamples) {
  const TimeGrid grid{0.37, 0.02, 101};
  const Window window = make_window(grid, {-1.0, 3.0}, 4.0, 24.0);
  EXPECT_LE(window.dt, 1.0 / (4.0 * 24.0));
  EXPECT_NEAR(window.dt * static_cast<double>(window.stride), grid.dt, 1e-15);
  EXPECT_NEAR(window.start + static_cast<double>(window.offset) * window.dt, grid.start, 1e-12);
  EXPECT_LT(window.offset + 100 * window.stride, window.length);
  EXPECT_GE(window.duration(), 16.0);
  EXPECT_LT(window.start, -1.0 - 5.9); // padding on both sides
  EXPECT_GT(window.start + window.duration(), 3.0 + 5.9);
}

const SynthesisOptions exponential{.exponential_window = true};

LayeredField field(const LayeredHalfSpace& profile, WaveType wave, double degrees,
                   const SynthesisOptions& options) {
  return {profile, {wave, radians(degrees), 0.0, -20.0}, 0.0, ricker(3.0, 0.8, 0.1), options};
}

TEST(ExponentialWindow, AgreesWithPaddingWhereItIsValid) {
  const std::array<Point, 2> points{{{0.0, 0.0}, {10.0, -12.0}}};
  const TimeGrid grid{0.0, 0.01, 300};
  const auto difference = [&](const LayeredHalfSpace& profile, WaveType wave, double degrees) {
    const auto a = field(profile, wave, degrees, {}).sample(points, grid);
    const auto b = field(profile, wave, degrees, exponential).sample(points, grid);
    double result = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t t = 0; t < grid.count; ++t) {
        result = std::max({result, std::abs(a[i].vx[t] - b[i].vx[t]), std::abs(a[i].vy[t] - b[i].vy[t]),
                           3.0 * std::abs(a[i].ux[t] - b[i].ux[t])});
      }
    }
    return result / 0.1;
  };
  EXPECT_LT(difference(layered3({}), WaveType::SV, 20.0), 1e-6);
  EXPECT_LT(difference(layered3({}), WaveType::P, 60.0), 1e-6);
  EXPECT_LT(difference(layered3({DampingModel::kelvin_voigt, 3.0}), WaveType::SV, 0.0), 1e-6);
  EXPECT_LT(difference(layered3({DampingModel::kjartansson, 3.0}), WaveType::SV, 0.0), 1e-6);
  EXPECT_LT(difference(layered3({DampingModel::constant, 3.0}), WaveType::SV, 0.0), 1e-6);
}

TEST(ExponentialWindow, IsRefusedWithTheReasonWhereItIsNot) {
  const auto refused = [](const LayeredHalfSpace& profile, double degrees, const std::string& words) {
    EXPECT_THAT([&] { field(profile, WaveType::SV, degrees, exponential); },
                ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
  };
  refused(layered3({DampingModel::hysteretic}), 0.0, "is not causal");
  refused(layered3({DampingModel::shake}), 20.0, "is not causal");
  refused(layered3({DampingModel::kelvin_voigt, 3.0}), 20.0,
          "with damping (kelvin_voigt) and oblique incidence");
  refused(layered3({}), 40.0, "P waves in the half-space (vp = 1000 m/s) are evanescent");
  LayeredHalfSpace inversion = layered3({});
  inversion.layers[0].vp = 2000.0;
  refused(inversion, 20.0, "P waves in layer 1 from the top (vp = 2000 m/s) are evanescent");
}

TEST(WrapAroundError, IsWhatATooShortWindowCosts) {
  // A stiff rock keeps the soil ringing: a window of twice the time asked for is too short, the chosen one
  // not.
  LayeredHalfSpace profile = layered3({});
  profile.half_space = {2600.0, 3000.0, 5500.0};
  const Point surface{0.0, 0.0};
  const TimeGrid grid{0.0, 0.01, 300};
  const WrapAroundError with_chosen =
      field(profile, WaveType::SV, 20.0, {}).wrap_around_error({&surface, 1}, grid);
  const WrapAroundError too_short =
      field(profile, WaveType::SV, 20.0, {.padding = 2.0}).wrap_around_error({&surface, 1}, grid);
  EXPECT_LT(with_chosen.velocity, 1e-9);
  EXPECT_GT(too_short.velocity, 1e-4);
  EXPECT_GT(with_chosen.window, 4.0 * too_short.window);

  // What it reports is the error: the difference to the chosen window.
  const auto a = field(profile, WaveType::SV, 20.0, {}).sample({&surface, 1}, grid);
  const auto b = field(profile, WaveType::SV, 20.0, {.padding = 2.0}).sample({&surface, 1}, grid);
  double difference = 0.0;
  double peak = 0.0;
  for (std::size_t t = 0; t < grid.count; ++t) {
    difference = std::max({difference, std::abs(a[0].vx[t] - b[0].vx[t]), std::abs(a[0].vy[t] - b[0].vy[t])});
    peak = std::max({peak, std::abs(a[0].vx[t]), std::abs(a[0].vy[t])});
  }
  EXPECT_GT(too_short.velocity, 0.5 * difference / peak);
  EXPECT_LT(too_short.velocity, 2.0 * difference / peak);
}

TEST(WrapAroundError, RefusesAPaddingBelowOne) {
  EXPECT_THROW(field(layered3({}), WaveType::SV, 20.0, {.padding = 0.5}), std::invalid_argument);
}

} // namespace
