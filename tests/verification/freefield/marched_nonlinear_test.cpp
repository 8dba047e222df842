// Hysteretic layers in the marched column: at vertical incidence the column by the method of lines is the
// second method; obliquely, small strains are the elastic column's, and differences between grids fall as
// second order says.

#include "freefield/marched/marched_column.hpp"
#include "freefield/ode/ode_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;

constexpr double angle = 20.0 * std::numbers::pi / 180.0;
constexpr std::array<double, 4> levels = {0.0, -3.0, -6.0, -17.0};

Profile profile(double reference_strain) {
  return {.layers = {layer_of(8.0, MasingShear{Elasticity::from_wave_speeds(1700.0, 120.0, 240.0),
                                               reference_strain, 1.0, 0.919}),
                     {12.0, Elasticity::from_wave_speeds(1900.0, 250.0, 500.0)}},
          .half_space = Elasticity::from_wave_speeds(2100.0, 500.0, 1000.0)};
}

InputVelocity pulse(double velocity, double direction) {
  return [=](double t) {
    const double a = std::pow(std::numbers::pi * 2.0 * (t - 0.7), 2);
    const double v = velocity * (1.0 - 2.0 * a) * std::exp(-a);
    return Velocity{v * std::cos(direction), -v * std::sin(direction)};
  };
}

constexpr double interval = 0.02;
constexpr int intervals = 100;

/// vx, vy, sxy at the levels, interval after interval.
std::vector<double> history(Column& column) {
  std::vector<double> values;
  std::array<ColumnSample, 4> samples;
  for (int i = 1; i <= intervals; ++i) {
    while (column.time() < interval * i - 0.5 * column.time_step()) {
      column.step();
    }
    column.sample(levels, samples);
    for (const ColumnSample& s : samples) {
      values.insert(values.end(), {s.vx, s.vy, s.sxy / 2e5, s.gxy * 100.0});
    }
  }
  return values;
}

std::vector<double> marched(const Profile& soil, double velocity, double direction, double cell,
                            double step) {
  MarchedColumn column(
      soil, {.max_element_size = cell, .time_step = step, .slowness_x = std::sin(direction) / 500.0},
      pulse(velocity, direction));
  return history(column);
}

/// Root-mean-square difference over that of the second.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0.0, total = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += (a[i] - b[i]) * (a[i] - b[i]);
    total += b[i] * b[i];
  }
  return std::sqrt(squares / total);
}

TEST(MarchedNonlinear, VerticallyIsTheColumnByTheMethodOfLines) {
  OdeColumnSettings settings;
  settings.max_cell_size = 0.0625;
  settings.time_step = interval;
  settings.relative_tolerance = 1e-7;
  settings.absolute_tolerance = 1e-9;
  OdeColumn reference(profile(1e-3), settings, pulse(0.1, 0.0));
  const auto exact = history(reference);
  const double coarse = difference(marched(profile(1e-3), 0.1, 0.0, 0.25, 2.5e-4), exact);
  const double fine = difference(marched(profile(1e-3), 0.1, 0.0, 0.125, 1.25e-4), exact);
  std::printf("difference %.2e %.2e\n", coarse, fine);
  EXPECT_LT(fine, 3e-3);
  EXPECT_LT(fine, 0.5 * coarse);
}

TEST(MarchedNonlinear, FarBelowItsReferenceStrainSoilIsElastic) {
  Profile elastic = profile(1.0);
  elastic.layers[0].law.reset();
  const auto expected = marched(elastic, 0.1, angle, 0.5, 5e-4);
  EXPECT_LT(difference(marched(profile(1e4), 0.1, angle, 0.5, 5e-4), expected), 1e-5);
  EXPECT_GT(difference(marched(profile(1e-3), 0.1, angle, 0.5, 5e-4), expected), 0.1);
}

// Where soil yields and turns back, second derivatives of the motion jump and no scheme keeps order two. A
// smooth rise before its reflection comes back loads the soil monotonically.
TEST(MarchedNonlinear, ConvergesAtSecondOrderAtTwentyDegreesUnderMonotonicLoading) {
  Profile soil = profile(1e-3);
  soil.layers[0] = layer_of(40.0, MasingShear{soil.layers[0].soil, 5e-4, 1.0, 1.0});
  const InputVelocity rise = [](double t) {
    const double v = 0.1 * (1.0 + std::erf((t - 0.6) / 0.1));
    return Velocity{v * std::cos(angle), -v * std::sin(angle)};
  };
  constexpr std::array<double, 3> within = {-26.0, -30.25, -35.3};
  double strain = 0.0;
  const auto run = [&](double cell) {
    MarchedColumn column(
        soil, {.max_element_size = cell, .time_step = 5e-4 * cell, .slowness_x = std::sin(angle) / 500.0},
        rise);
    std::vector<double> values;
    std::array<ColumnSample, 3> samples;
    while (column.time() < 0.74) {
      while (column.time() < interval * (1.0 + static_cast<double>(values.size() / 12)) - 1e-6) {
        column.step();
      }
      column.sample(within, samples);
      for (const ColumnSample& s : samples) {
        values.insert(values.end(), {s.vx, s.vy, s.sxy / 2e5, s.gxy * 100.0});
        strain = std::max(strain, std::abs(s.gxy));
      }
    }
    return values;
  };
  const auto coarse = run(0.8);
  const auto medium = run(0.4);
  const auto fine = run(0.2);
  const double first = difference(coarse, medium);
  const double second = difference(medium, fine);
  std::printf("differences %.2e %.2e order %.2f, strain %.1e\n", first, second, std::log2(first / second),
              strain);
  EXPECT_GT(std::log2(first / second), 1.8);
  EXPECT_GT(strain, 5e-4); // the soil yields: a quarter of its tangent is left at gamma_r
}

} // namespace
