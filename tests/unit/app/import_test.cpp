// Imported motions: units, signs, rates and even steps against closed forms.

#include "app/recording/import_motion.hpp"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace tremolo::app {
namespace {

using ::testing::HasSubstr;

constexpr double omega = 2.0 * std::numbers::pi * 3.0;
constexpr double density = 1700.0;
constexpr double speed = 100.0;

double velocity(double t, double y) {
  const double s = t - y / speed;
  return s <= 0.0 ? 0.0 : std::pow(s, 6) * std::sin(omega * s);
}

double acceleration(double t, double y) {
  const double s = t - y / speed;
  return s <= 0.0 ? 0.0
                  : 6.0 * std::pow(s, 5) * std::sin(omega * s) + std::pow(s, 6) * omega * std::cos(omega * s);
}

/// A shear wave that travels up through three levels, at these times.
ReadMotion upgoing(const std::vector<double>& times, const std::vector<double>& depths) {
  ReadMotion motion{.times = times, .depths = depths, .values = {}, .notes = {}};
  for (const double t : times)
    for (const double depth : depths) {
      const double v = velocity(t, -depth);
      motion.values.insert(motion.values.end(), {v, 0.0, 0.0, 0.0, -density * speed * v});
    }
  return motion;
}

std::vector<double> grid(std::size_t count, double step, double wobble = 0.0) {
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(static_cast<double>(i) * step + (i % 2 == 1 ? wobble * step : 0.0));
  return times;
}

/// Largest error of component k (0 velocity, 5 its rate) at the surface.
double error(const coupler::ServedSeries& series, std::size_t component, double (*exact)(double, double)) {
  double worst = 0.0;
  for (std::uint64_t n = 0; n < series.steps(); ++n) {
    const double* top =
        series.values.data() + (n + 1) * series.field.values_per_step() - coupler::values_per_point;
    worst = std::max(worst, std::abs(top[component] - exact(series.field.time(n), 0.0)));
  }
  return worst;
}

TEST(Import, RatesAreOfFourthOrderUpToTheEnds) {
  const auto coarse = error(field_from(upgoing(grid(101, 0.01), {1.0, 0.5, 0.0}), {}), 5, acceleration);
  const auto fine = error(field_from(upgoing(grid(201, 0.005), {1.0, 0.5, 0.0}), {}), 5, acceleration);
  EXPECT_GT(std::log2(coarse / fine), 3.7);
  EXPECT_LT(fine, 1e-3 * omega);
}

TEST(Import, ResamplingIsOfThirdOrder) {
  Conventions conventions;
  conventions.resample = 0.004;
  const auto coarse =
      error(field_from(upgoing(grid(101, 0.01, 0.3), {1.0, 0.5, 0.0}), conventions), 0, velocity);
  const auto fine =
      error(field_from(upgoing(grid(201, 0.005, 0.3), {1.0, 0.5, 0.0}), conventions), 0, velocity);
  EXPECT_GT(std::log2(coarse / fine), 2.7);
  EXPECT_LT(fine, 1e-3);
  conventions.resample.reset();
  EXPECT_THROW(field_from(upgoing(grid(101, 0.01, 0.3), {1.0, 0.5, 0.0}), conventions), std::runtime_error);
}

TEST(Import, UnitsSignsAndAxes) {
  ReadMotion motion = upgoing(grid(11, 0.1), {2.0, 1.0, 0.0});
  for (std::size_t i = 0; i < motion.values.size(); ++i)
    motion.values[i] = static_cast<double>(1 + i % 5); // vx 1, vy 2, sxx 3, syy 4, sxy 5
  const Conventions conventions{.velocity_unit = 1e-2,
                                .stress_unit = 1e3,
                                .length_unit = 0.3048,
                                .compression = true,
                                .depth_down = true,
                                .vertical_down = true,
                                .surface = 10.0,
                                .time_shift = -2.0};
  const auto series = field_from(motion, conventions);
  EXPECT_DOUBLE_EQ(series.field.y.front(), 10.0 - 2.0 * 0.3048);
  EXPECT_EQ(series.field.y.back(), 10.0);
  EXPECT_EQ(series.field.start_time, -2.0);
  const std::vector<double> first(series.values.begin(), series.values.begin() + 5);
  EXPECT_EQ(first, (std::vector<double>{0.01, -0.02, -3e3, -4e3, 5e3}));
}

std::string refusal(const std::function<void(Conventions&)>& change) {
  Conventions conventions;
  change(conventions);
  std::vector<double> depths;
  for (int k = 20; k >= 0; --k)
    depths.push_back(0.5 * k);
  ReadMotion motion = upgoing(grid(201, 0.005), depths);
  if (!conventions.depth_down)
    for (double& depth : motion.depths) // as they would stand in the file
      depth = -depth;
  try {
    return check_imported(field_from(motion, conventions), conventions).front();
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(Import, MomentumTellsWrongUnitsAndSigns) {
  EXPECT_THAT(refusal([](Conventions&) {}),
              HasSubstr("the horizontal motion obeys rho a = div sigma with rho = 1"));
  EXPECT_THAT(refusal([](Conventions& c) { c.stress_unit = 1e3; }), HasSubstr("--stress-unit Pa"));
  EXPECT_THAT(refusal([](Conventions& c) { c.velocity_unit = 1e-2; }), HasSubstr("--velocity-unit m/s"));
  EXPECT_THAT(refusal([](Conventions& c) { c.compression = true; }), HasSubstr("a sign is wrong"));
  EXPECT_THAT(refusal([](Conventions& c) { c.vertical_down = true; }), HasSubstr("a sign is wrong"));
  EXPECT_THAT(refusal([](Conventions& c) { c.density = 2400.0; }), HasSubstr("outside 1920 to 2880"));
}

} // namespace
} // namespace tremolo::app
