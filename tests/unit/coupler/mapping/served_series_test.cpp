// What the values of a field say of themselves, against a plane wave that is known in closed form.

#include "coupler/mapping/served_series.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace tremolo::coupler {
namespace {

constexpr double density = 1800.0;
constexpr double shear_speed = 150.0;
constexpr double omega = 20.0;

/// An upgoing SV wave of horizontal slowness p: v = (cos, -sin) f, shear stress mu (dvx/dy + dvy/dx), normal
/// stresses +-2 mu dvx/dx.
ServedSeries oblique_wave(double p, double dt, int points) {
  ServedSeries series{.field = {.name = "total", .slowness_x = p, .time_step = dt, .step_count = 200},
                      .values = {}};
  for (int i = 0; i < points; ++i)
    series.field.y.push_back(-5.0 + 5.0 * i / (points - 1) + 0.1 * std::sin(i));
  const double sine = p * shear_speed;
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double q = cosine / shear_speed;
  const double mu = density * shear_speed * shear_speed;
  for (std::uint64_t n = 0; n < series.field.step_count; ++n)
    for (const double y : series.field.y) {
      const double phase = omega * (series.field.time(n) - q * y);
      const auto add = [&](double f) { // of f(t - p x - q y): displacements' rates vx = cos f, and so on
        const double sxx = -2.0 * mu * p * cosine * f;
        const double sxy = -mu * (q * cosine - p * sine) * f;
        series.values.insert(series.values.end(), {cosine * f, -sine * f, sxx, -sxx, sxy});
      };
      add(std::sin(phase));
      add(omega * std::cos(phase));
    }
  return series;
}

TEST(ServedSeries, DensityFollowsFromMomentumAtSecondOrder) {
  for (const double p : {0.0, 0.004}) {
    const double coarse = std::abs(*density_from_momentum(oblique_wave(p, 0.01, 11)) - density);
    const double fine = std::abs(*density_from_momentum(oblique_wave(p, 0.01, 41)) - density);
    EXPECT_LT(fine, 0.01 * density);
    EXPECT_LT(fine, 0.25 * coarse);
  }
}

TEST(ServedSeries, UnitsAndSignsShowInTheDensity) {
  auto series = oblique_wave(0.002, 0.01, 41);
  for (std::size_t i = 0; i < series.values.size(); ++i)
    if (i % 5 >= 2)
      series.values[i] *= -1e-3; // kPa, tension negative
  EXPECT_NEAR(*density_from_momentum(series), -1e-3 * density, 1e-5 * density);
}

/// A shear stress of the wrong sign is wrong in both directions of an oblique wave, and fits nothing.
TEST(ServedSeries, EachDirectionHasAMomentumOfItsOwn) {
  auto series = oblique_wave(0.002, 0.01, 81);
  for (const auto direction : {Direction::horizontal, Direction::vertical}) {
    const auto fit = momentum_fit(series, direction);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->density, density, 0.01 * density);
    EXPECT_LT(fit->misfit, 0.01);
  }
  for (std::size_t i = 0; i < series.values.size(); i += values_per_point)
    series.values[i + 1] = series.values[i + 6] = 0.0;
  EXPECT_TRUE(momentum_fit(series, Direction::horizontal));
  EXPECT_FALSE(momentum_fit(series, Direction::vertical)) << "nothing moves vertically";
  for (std::size_t i = 0; i < series.values.size(); i += values_per_point)
    std::swap(series.values[i + 5], series.values[i]); // accelerations a quarter of a period off
  EXPECT_GT(momentum_fit(series, Direction::horizontal)->misfit, 0.9);
}

TEST(ServedSeries, MomentumNeedsThreePointsOfOneLayer) {
  ServedSeries series{
      .field = {.name = "total", .y = {-1.0, 0.0, 0.0, 1.0}, .time_step = 0.1, .step_count = 3},
      .values = std::vector<double>(3 * 4 * values_per_point, 1.0)};
  EXPECT_FALSE(density_from_momentum(series));
}

TEST(ServedSeries, RateDefectFallsAtFourthOrder) {
  const double coarse = rate_defect(oblique_wave(0.002, 0.02, 3));
  const double fine = rate_defect(oblique_wave(0.002, 0.01, 3));
  EXPECT_NEAR(coarse, std::pow(omega * 0.02, 4) / 180.0, 0.1 * coarse); // Simpson's error term
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.1);
}

TEST(ServedSeries, RatesOfAnotherClockAreADefect) {
  auto series = oblique_wave(0.002, 0.005, 3);
  series.field.time_step = 0.01;
  EXPECT_NEAR(rate_defect(series), 0.5, 0.01); // half of the larger side is left over
}

TEST(ServedSeries, SilenceHasNoDefect) {
  ServedSeries series{.field = {.name = "total", .y = {0.0}, .time_step = 0.1, .step_count = 5},
                      .values = std::vector<double>(5 * values_per_point, 0.0)};
  EXPECT_EQ(rate_defect(series), 0.0);
  EXPECT_EQ(peaks(series, 0, 4).velocity, 0.0);
}

} // namespace
} // namespace tremolo::coupler
