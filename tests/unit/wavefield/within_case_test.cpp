// A within motion drives the base as a rigid one would be driven, also after its record has ended and the
// layers still ring: the surface is that of the layers on a base that moves as given and then stands still,
//
//     surface / base = 1 / (cos k1 h1 cos k2 h2 - G1 k1 / (G2 k2) sin k1 h1 sin k2 h2),    k^2 = rho w^2 / G,
//
// with G = rho vs^2 (1 + 2 i xi w / w0): it knows no half-space.

#include "scene/case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace tremolo;
using Complex = std::complex<double>;

const std::string within_case = R"(title = "within"
[motion]
pulse = { shape = "ricker", frequency = 3.0, time = 0.5, velocity = 0.1 }
wave = "SV"
angle_deg = 0
reference = [0, -10]
kind = "within"
[surface]
level = 0.0
[halfspace]
density = 1900.0
vs = 200.0
vp = 400.0
[[profile]]
thickness = 4.0
soil = "soft"
[[profile]]
thickness = 6.0
soil = "firm"
[damping]
model = "kelvin_voigt"
ratio = 0.05
reference_hz = 3.0
[soil.soft]
model = "linear_elastic"
density = 1600.0
vs = 80.0
vp = 160.0
[soil.firm]
model = "linear_elastic"
density = 1700.0
vs = 120.0
vp = 240.0
[[region]]
soil = "soft"
polygon = [[0.0, -4.0], [10.0, -4.0], [10.0, 0.0], [0.0, 0.0]]
[[region]]
soil = "firm"
polygon = [[0.0, -10.0], [10.0, -10.0], [10.0, -4.0], [0.0, -4.0]]
[mesh]
size = 1.0
box = [0.0, -10.0, 10.0, 0.0]
[boundary]
left = { model = "wave" }
right = { model = "wave" }
base = { model = "wave" }
[[stage]]
kind = "shaking"
duration_s = 1.0
)";

constexpr double pi = std::numbers::pi;
constexpr double pulse_hz = 3.0;
constexpr double pulse_time = 0.5;
constexpr double pulse_velocity = 0.1;

double base_velocity(double t) {
  const double a = std::pow(pi * pulse_hz * (t - pulse_time), 2);
  return pulse_velocity * (1.0 - 2.0 * a) * std::exp(-a);
}

Complex surface_over_base(double omega) {
  const Complex loss(1.0, 2.0 * 0.05 * omega / (2.0 * pi * 3.0));
  const Complex k1h1 = omega * 4.0 / (80.0 * std::sqrt(loss));
  const Complex k2h2 = omega * 6.0 / (120.0 * std::sqrt(loss));
  const double impedances = 1600.0 * 80.0 / (1700.0 * 120.0);
  return 1.0 / (std::cos(k1h1) * std::cos(k2h2) - impedances * std::sin(k1h1) * std::sin(k2h2));
}

/// Sum over frequencies of the pulse's spectrum 2 f^2 / (sqrt(pi) f0^3) exp(-(f/f0)^2), repeated every 40 s.
double surface_velocity(double t) {
  constexpr double step_hz = 1.0 / 40.0;
  double sum = 0.0;
  for (double f = step_hz; f < 7.0 * pulse_hz; f += step_hz) {
    const double omega = 2.0 * pi * f;
    const double amplitude =
        2.0 * f * f / (std::sqrt(pi) * std::pow(pulse_hz, 3)) * std::exp(-std::pow(f / pulse_hz, 2));
    sum += 2.0 * step_hz * amplitude *
           (surface_over_base(omega) * std::polar(1.0, omega * (t - pulse_time))).real();
  }
  return pulse_velocity * sum;
}

TEST(WithinMotionOfACase, HoldsTheBaseAfterItsRecordHasEnded) {
  const scene::Case scene = scene::parse(within_case, "case.toml", ".");
  const auto field = wavefield::elastic_field(scene, scene.profile, scene.surface_level);
  const std::array<wavefield::Point, 2> points{{{0.0, 0.0}, {0.0, -10.0}}};
  const wavefield::TimeGrid grid{0.0, 0.02, 300};
  const auto histories = field.sample(points, grid);

  double largest_base_error = 0.0;
  double largest_surface_error = 0.0;
  double largest_surface = 0.0;
  double ringing = 0.0;
  for (std::size_t i = 0; i < grid.count; ++i) {
    const double t = static_cast<double>(i) * grid.dt;
    const double surface = surface_velocity(t);
    largest_base_error = std::max(largest_base_error, std::abs(histories[1].vx[i] - base_velocity(t)));
    largest_surface_error = std::max(largest_surface_error, std::abs(histories[0].vx[i] - surface));
    largest_surface = std::max(largest_surface, std::abs(surface));
    if (t > 1.3) // the pulse has ended
      ringing = std::max(ringing, std::abs(surface));
  }
  EXPECT_GT(ringing, 0.5 * pulse_velocity);
  EXPECT_LT(largest_base_error, 1e-6 * pulse_velocity);
  EXPECT_LT(largest_surface_error, 1e-6 * largest_surface);
}

} // namespace
