#include "app/verify/exact_velocity.hpp"

#include "wavefield/superposition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace {

using namespace tremolo;

constexpr double frequency = 3.0;
constexpr double peak = 0.1;

/// Largest difference of values, and of rates over 2 pi f, from the field sampled at the very points and
/// times, over the peak of the incident pulse.
double largest_difference(const std::vector<wavefield::Incidence>& incidences) {
  const auto signal = wavefield::ricker(frequency, 0.6, peak);
  std::vector<wavefield::LayeredField> waves;
  for (const wavefield::Incidence& incidence : incidences)
    waves.emplace_back(wavefield::LayeredHalfSpace{.half_space = {1700.0, 95.87, 173.44}}, incidence, 0.0,
                       signal);
  const wavefield::Superposition field(std::move(waves));
  const std::array<double, 3> levels{-10.0, -3.3, 0.0};
  const app::ExactVelocity exact(field, levels, {-5.0, 30.0, 0.0, 1.6}, signal.highest_frequency);

  const wavefield::TimeGrid grid{0.0, 0.0137, 117}; // no multiple of the interpolant's own step
  const double omega = 2.0 * 3.14159265358979 * frequency;
  double difference = 0.0;
  for (std::size_t level = 0; level < levels.size(); ++level)
    for (const double x : {-5.0, 7.77, 30.0}) {
      const std::array<wavefield::Point, 1> point{{{x, levels[level]}}};
      const auto history = field.sample(point, grid).front();
      for (std::size_t i = 0; i < grid.count; ++i) {
        const auto e = exact.at(level, x, static_cast<double>(i) * grid.dt);
        difference = std::max({difference, std::abs(e.vx - history.vx[i]), std::abs(e.vy - history.vy[i]),
                               std::abs(e.ax - history.vx_rate[i]) / omega,
                               std::abs(e.ay - history.vy_rate[i]) / omega});
      }
    }
  return difference / peak;
}

// (omega dt)^4 / 384 of values at 3 Hz, dt = 1/(32 x 19.5) s is 2e-9, and (omega dt)^3 / 125 of rates 2e-7.
TEST(ExactVelocity, IsTheFieldAnywhereInTheBox) {
  EXPECT_LT(largest_difference({{wavefield::WaveType::SV, 0.26, 0.0, -10.0}}), 1e-6);
  EXPECT_LT(largest_difference({{wavefield::WaveType::SV, 0.0, 3.0, -10.0}}), 1e-6);
  EXPECT_LT(largest_difference({{wavefield::WaveType::P, 0.8, 0.0, -10.0}}), 1e-6);
}

TEST(ExactVelocity, IsThatOfAllWaves) {
  EXPECT_LT(largest_difference(
                {{wavefield::WaveType::SV, 0.26, 0.0, -10.0}, {wavefield::WaveType::P, 0.8, 2.0, -9.0}}),
            2e-6);
}

TEST(ExactVelocity, IsTheFieldBeyondTheCriticalAngle) {
  EXPECT_LT(largest_difference({{wavefield::WaveType::SV, 0.7, 0.0, -10.0}}), 1e-6);
}

} // namespace
