#include "wavefield/layers/layered_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace tremolo::wavefield;

const HalfSpace soil{1700.0, 96.0, 174.0};
constexpr double surface = 3.0;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

LayeredField field(WaveType wave, double degrees) {
  return {{.half_space = soil}, {wave, radians(degrees), 5.0, -30.0}, surface, ricker(3.0, 0.8, 0.1)};
}

double pulse(double t) {
  const double a = std::pow(std::numbers::pi * 3.0 * (t - 0.8), 2);
  return 0.1 * (1.0 - 2.0 * a) * std::exp(-a);
}

/// Integral of the pulse, and its derivative.
double pulse_integral(double t) {
  const double a = std::pow(std::numbers::pi * 3.0 * (t - 0.8), 2);
  return 0.1 * (t - 0.8) * std::exp(-a);
}
double pulse_rate(double t) {
  const double k = std::numbers::pi * 3.0;
  const double z = k * (t - 0.8);
  return 0.1 * k * (4.0 * z * z * z - 6.0 * z) * std::exp(-z * z);
}

TEST(LayeredField, BelowCriticalIsThreeDelayedPulses) {
  const double degrees = 20.0;
  const Point point{31.7, -12.9};
  const TimeGrid grid{0.3, 0.013, 180};
  const History h = field(WaveType::SV, degrees).sample({&point, 1}, grid)[0];

  const double a = soil.vp;
  const double b = soil.vs;
  const double p = std::sin(radians(degrees)) / b;
  const double qa = std::sqrt(1.0 / (a * a) - p * p);
  const double qb = std::cos(radians(degrees)) / b;
  const double c2 = 1.0 - 2.0 * b * b * p * p;
  const double x = 4.0 * std::pow(b, 4) * p * p * qa * qb;
  const double r_s = (c2 * c2 - x) / (c2 * c2 + x);
  const double r_p = 4.0 * b * b * b / a * p * qb * c2 / (c2 * c2 + x);
  const double depth = point.y - surface;
  const double to_reference = p * (point.x - 5.0) - qb * (-30.0 - surface);
  for (std::size_t i = 0; i < grid.count; ++i) {
    const double t = grid.start + static_cast<double>(i) * grid.dt - to_reference;
    const double up = t - qb * depth;
    const double down_p = t + qa * depth;
    const double down_s = t + qb * depth;
    EXPECT_NEAR(h.vx[i], b * qb * (pulse(up) + r_s * pulse(down_s)) + r_p * a * p * pulse(down_p), 1e-12);
    EXPECT_NEAR(h.vy[i], -b * p * pulse(up) + r_s * b * p * pulse(down_s) - r_p * a * qa * pulse(down_p),
                1e-12);
    EXPECT_NEAR(h.ux[i],
                b * qb * (pulse_integral(up) + r_s * pulse_integral(down_s)) +
                    r_p * a * p * pulse_integral(down_p),
                1e-13);
    EXPECT_NEAR(h.vx_rate[i],
                b * qb * (pulse_rate(up) + r_s * pulse_rate(down_s)) + r_p * a * p * pulse_rate(down_p),
                1e-10);
  }
}

TEST(LayeredField, OfTheIncidentPartIsTheSignalAtTheReferencePoint) {
  const Point reference{5.0, -30.0};
  const TimeGrid grid{0.0, 0.01, 160};
  for (const double degrees :
       {0.0, 25.0, 60.0}) { // 60: beyond critical, which the incident wave does not feel
    const double s = std::sin(radians(degrees));
    const double c = std::cos(radians(degrees));
    const History sv = field(WaveType::SV, degrees).sample({&reference, 1}, grid, Part::incident)[0];
    const History p = field(WaveType::P, degrees).sample({&reference, 1}, grid, Part::incident)[0];
    for (std::size_t i = 0; i < grid.count; ++i) {
      const double v = pulse(0.01 * static_cast<double>(i));
      EXPECT_NEAR(sv.vx[i], c * v, 1e-13);
      EXPECT_NEAR(sv.vy[i], -s * v, 1e-13);
      EXPECT_NEAR(p.vx[i], s * v, 1e-13);
      EXPECT_NEAR(p.vy[i], c * v, 1e-13);
      // Stress of a plane wave on a face normal to its path: rho c v against the motion.
      const double along = sv.sxx[i] * s * s + 2.0 * sv.sxy[i] * s * c + sv.syy[i] * c * c;
      const double across = (sv.sxx[i] - sv.syy[i]) * s * c + sv.sxy[i] * (c * c - s * s);
      EXPECT_NEAR(along, 0.0, 1e-7);
      EXPECT_NEAR(across, -soil.density * soil.vs * v, 1e-7);
      const double normal = p.sxx[i] * s * s + 2.0 * p.sxy[i] * s * c + p.syy[i] * c * c;
      EXPECT_NEAR(normal, -soil.density * soil.vp * v, 1e-7);
    }
  }
}

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) {
    result = std::max(result, std::abs(value));
  }
  return result;
}

class AnyAngle : public ::testing::TestWithParam<double> {};

TEST_P(AnyAngle, TractionVanishesAtTheSurface) {
  const Point points[] = {{0.0, surface}, {73.0, surface}};
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    for (const History& h : field(wave, GetParam()).sample(points, {0.0, 0.01, 300})) {
      const double scale = 0.1 * soil.density * soil.vp;
      EXPECT_LT(largest(h.sxy), 1e-12 * scale);
      EXPECT_LT(largest(h.syy), 1e-12 * scale);
      EXPECT_GT(std::max(largest(h.vx), largest(h.vy)), 0.01);
    }
  }
}

TEST_P(AnyAngle, TheFieldAtXIsTheDelayedFieldAtTheReference) {
  const LayeredField sv = field(WaveType::SV, GetParam());
  const double dt = 0.01;
  // As far along x as the wave runs in 12 steps.
  const double distance = GetParam() > 0.0 ? 12.0 * dt / sv.slowness_x() : 40.0;
  const std::size_t delay = GetParam() > 0.0 ? 12 : 0;
  const Point points[] = {{5.0, -7.0}, {5.0 + distance, -7.0}};
  const auto h = sv.sample(points, {0.0, dt, 250});
  for (std::size_t i = delay; i < 250; ++i) {
    EXPECT_NEAR(h[1].vx[i], h[0].vx[i - delay], 1e-9);
    EXPECT_NEAR(h[1].sxy[i], h[0].sxy[i - delay], 1e-9 * soil.density * soil.vp);
    EXPECT_NEAR(h[1].uy[i], h[0].uy[i - delay], 1e-9);
  }
}

TEST_P(AnyAngle, RatesAndDisplacementsBelongToTheVelocities) {
  const double dt = 1e-3;
  const Point point{20.0, -4.0};
  const History h = field(WaveType::SV, GetParam()).sample({&point, 1}, {0.6, dt, 900})[0];
  const auto expect_derivative = [&](const std::vector<double>& value, const std::vector<double>& rate) {
    for (std::size_t i = 4; i + 4 < value.size(); ++i) { // eighth-order central difference
      const double difference =
          (4.0 / 5.0 * (value[i + 1] - value[i - 1]) - 1.0 / 5.0 * (value[i + 2] - value[i - 2]) +
           4.0 / 105.0 * (value[i + 3] - value[i - 3]) - 1.0 / 280.0 * (value[i + 4] - value[i - 4])) /
          dt;
      ASSERT_NEAR(rate[i], difference, 1e-9 * largest(rate) + 1e-12);
    }
  };
  expect_derivative(h.ux, h.vx);
  expect_derivative(h.uy, h.vy);
  expect_derivative(h.vx, h.vx_rate);
  expect_derivative(h.vy, h.vy_rate);
  expect_derivative(h.sxx, h.sxx_rate);
  expect_derivative(h.syy, h.syy_rate);
  expect_derivative(h.sxy, h.sxy_rate);
}

// rho dv/dt = div sigma and dsigma/dt = Hooke(grad v), by eighth-order differences in space.
TEST_P(AnyAngle, SatisfiesMomentumBalanceAndHookesLaw) {
  constexpr double weights[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  const double h = 0.25;
  std::vector<Point> points = {{12.0, -6.0}};
  for (int k = 1; k <= 4; ++k) {
    points.insert(points.end(),
                  {{12.0 + h * k, -6.0}, {12.0 - h * k, -6.0}, {12.0, -6.0 + h * k}, {12.0, -6.0 - h * k}});
  }
  const double mu = soil.density * soil.vs * soil.vs;
  const double lambda = soil.density * soil.vp * soil.vp - 2.0 * mu;
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    const auto at = field(wave, GetParam()).sample(points, {0.8, 0.02, 40});
    const auto slope = [&](std::vector<double> History::*q, std::size_t first, std::size_t i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += weights[k] * ((at[4 * k + first].*q)[i] - (at[4 * k + first + 1].*q)[i]);
      }
      return sum / h;
    };
    const auto ddx = [&](std::vector<double> History::*q, std::size_t i) { return slope(q, 1, i); };
    const auto ddy = [&](std::vector<double> History::*q, std::size_t i) { return slope(q, 3, i); };
    const double acceleration = std::max(largest(at[0].vx_rate), largest(at[0].vy_rate));
    const double stress_rate =
        std::max({largest(at[0].sxx_rate), largest(at[0].syy_rate), largest(at[0].sxy_rate)});
    for (std::size_t i = 0; i < 40; ++i) {
      EXPECT_NEAR(at[0].vx_rate[i], (ddx(&History::sxx, i) + ddy(&History::sxy, i)) / soil.density,
                  1e-7 * acceleration);
      EXPECT_NEAR(at[0].vy_rate[i], (ddx(&History::sxy, i) + ddy(&History::syy, i)) / soil.density,
                  1e-7 * acceleration);
      const double exx = ddx(&History::vx, i);
      const double eyy = ddy(&History::vy, i);
      EXPECT_NEAR(at[0].sxx_rate[i], (lambda + 2.0 * mu) * exx + lambda * eyy, 1e-7 * stress_rate);
      EXPECT_NEAR(at[0].syy_rate[i], (lambda + 2.0 * mu) * eyy + lambda * exx, 1e-7 * stress_rate);
      EXPECT_NEAR(at[0].sxy_rate[i], mu * (ddy(&History::vx, i) + ddx(&History::vy, i)), 1e-7 * stress_rate);
    }
  }
}

// 33.49 degrees is the critical angle of this soil.
INSTANTIATE_TEST_SUITE_P(Degrees, AnyAngle, ::testing::Values(0.0, 15.0, 33.0, 34.0, 40.0, 75.0));

TEST(LayeredField, DisplacementKeepsTheOffsetThatTheSignalLeaves) {
  // A velocity that leaves sqrt(pi)/k = 0.0886 m behind, once up and once back from the surface.
  const double k = 20.0;
  const Signal bump{[=](double t) { return std::exp(-k * k * (t - 1.0) * (t - 1.0)); }, 0.6, 1.4, 30.0};
  const LayeredField vertical({.half_space = soil}, {WaveType::SV, 0.0, 0.0, -30.0}, surface, bump);
  const Point point{0.0, -30.0};
  const History h = vertical.sample({&point, 1}, {0.0, 0.01, 400})[0];
  EXPECT_NEAR(h.ux.front(), 0.0, 1e-14);
  EXPECT_NEAR(h.ux[134], std::sqrt(std::numbers::pi) / k,
              1e-13); // 1.34 s: the first has passed, the second is to come
  EXPECT_NEAR(h.ux.back(), 2.0 * std::sqrt(std::numbers::pi) / k, 1e-13);
}

TEST(LayeredField, DoesNotDependOnTheGridItIsAskedFor) {
  const Point point{-8.0, -11.0};
  for (const double degrees : {15.0, 40.0}) {
    const LayeredField sv = field(WaveType::SV, degrees);
    const History coarse = sv.sample({&point, 1}, {0.5, 0.07, 20})[0];
    const History fine = sv.sample({&point, 1}, {-3.0, 0.0035, 1400})[0];
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_NEAR(coarse.vx[i], fine.vx[1000 + 20 * i], 1e-9);
      EXPECT_NEAR(coarse.uy[i], fine.uy[1000 + 20 * i], 1e-9);
    }
  }
}

template <class Call>
void expect_refused(Call call, const std::string& words) {
  EXPECT_THAT(call, ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
}

TEST(LayeredField, RefusesWhatHasNoField) {
  const LayeredField sv = field(WaveType::SV, 15.0);
  const Point above{0.0, surface + 0.1};
  const Point below{0.0, -1.0};
  const Point nowhere{std::nan(""), -1.0};
  const TimeGrid grid{0.0, 0.01, 10};
  expect_refused([&] { sv.sample({&above, 1}, grid); }, "not above the free surface at y = 3 m");
  expect_refused([&] { sv.sample({&nowhere, 1}, grid); }, "x of a point is nan");
  expect_refused([&] { sv.sample({&below, 1}, {0.0, 0.0, 10}); }, "step of the time grid is 0");
  expect_refused([&] { sv.sample({&below, 1}, {0.0, 0.01, 0}); }, "number of times is 0");
  expect_refused([&] { sv.sample({&below, 1}, {0.0, 1e-9, 1000000000}); }, "below 2^27");
  EXPECT_TRUE(sv.sample({}, grid).empty());
}

TEST(LayeredField, RefusesSignalsItCannotCarry) {
  const Point below{0.0, -1.0};
  const TimeGrid grid{0.0, 0.01, 10};
  const Incidence steep{WaveType::SV, radians(15.0), 0.0, 0.0};
  const Incidence shallow{WaveType::SV, radians(50.0), 0.0, 0.0};
  const Signal offset{[](double t) { return std::exp(-400.0 * (t - 1.0) * (t - 1.0)); }, 0.6, 1.4, 30.0};
  const Signal broken{[](double) { return std::nan(""); }, 0.0, 1.0, 10.0};
  EXPECT_NO_THROW(LayeredField({.half_space = soil}, steep, surface, offset).sample({&below, 1}, grid));
  expect_refused(
      [&] {
        LayeredField({.half_space = soil}, shallow, surface, offset).sample({&below, 1}, grid);
      },
      "remove the offset of the motion");
  expect_refused(
      [&] {
        LayeredField({.half_space = soil}, steep, surface, broken).sample({&below, 1}, grid);
      },
      "velocity of the signal at t = ");
  expect_refused([&] { LayeredField({.half_space = soil}, steep, surface, Signal{}); },
                 "no velocity function");
  expect_refused(
      [&] {
        LayeredField({.half_space = soil}, steep, surface, {offset.velocity, 1.0, 1.0, 30.0});
      },
      "end of the signal is 1");
  expect_refused(
      [&] {
        LayeredField({.half_space = soil}, steep, surface, {offset.velocity, 0.0, 1.0, 0.0});
      },
      "highest frequency of the signal is 0");
  expect_refused([&] { ricker(-3.0, 1.0, 0.1); }, "Ricker frequency is -3");
}

} // namespace
