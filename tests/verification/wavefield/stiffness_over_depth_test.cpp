// Soil of a case whose stiffness grows with depth, against closed forms of shear waves in it.
//
// With G(z) = b (z + c), z down from the surface, (G u')' + rho omega^2 u = 0 has the solutions J_0(x) and
// Y_0(x) of x = 2 omega sqrt(rho (z + c)/b); the surface is free of stress where A J_1 + B Y_1 = 0 (Gazetas
// 1982, Vibrational characteristics of soil deposits with variable wave velocity). With G(z) = g z^m and q =
// (1 - m)/(2 - m), p = (2 - m)/2, k = omega sqrt(rho/g)/p, the solution without stress at the surface is (k
// z^p)^q J_-q(k z^p) (Idriss & Seed 1968, Seismic response of horizontal soil layers). On an elastic
// half-space at depth H, its outcrop moves by u(H) + G u'(H)/(i omega rho_r v_r), since u = I + R and G u' =
// i omega rho_r v_r (I - R) there, and outcrop = 2 I.

#include "scene/case.hpp"
#include "wavefield/layers/transfer.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace tremolo::wavefield {
namespace {

constexpr double depth = 20.0;     // m
constexpr double density = 1800.0; // kg/m3
constexpr double rock_speed = 800.0;
constexpr double rock_density = 2200.0;

/// Displacement and G u' at a depth, up to one common factor.
struct Shape {
  double displacement;
  double stress;
};

using Closed = std::function<Shape(double omega, double z)>;

/// Surface over outcrop.
std::complex<double> amplification(const Closed& closed, double frequency) {
  const double omega = 2.0 * std::numbers::pi * frequency;
  const Shape base = closed(omega, depth);
  return closed(omega, 0.0).displacement /
         std::complex(base.displacement, -base.stress / (omega * rock_density * rock_speed));
}

/// A column of one soil on rock, cells of a size.
scene::Case column(const std::string& elastic, double cell) {
  return scene::parse(fmt::format(R"(title = "column"
[motion]
pulse = {{ shape = "ricker", frequency = 3.0, time = 1.0, velocity = 0.1 }}
wave = "SV"
angle_deg = 0.0
reference = [0.0, -{0}]
[surface]
level = 0.0
[halfspace]
density = {1}
vs = {2}
vp = 1600.0
[soil.sand]
model = "linear_elastic"
density = {3}
{4}
[[profile]]
thickness = {0}
soil = "sand"
[[region]]
soil = "sand"
polygon = [[0.0, -{0}], [20.0, -{0}], [20.0, 0.0], [0.0, 0.0]]
[mesh]
size = {5}
box = [0.0, -{0}, 20.0, 0.0]
[boundary]
left = {{ model = "wave" }}
right = {{ model = "wave" }}
base = {{ model = "wave" }}
[[stage]]
kind = "shaking"
duration_s = 2.0
)",
                                  depth, rock_density, rock_speed, density, elastic, cell),
                      "case.toml", ".");
}

/// Largest error of the amplification up to beyond the second resonance, over its largest value.
double error(const std::string& elastic, double cell, const Closed& closed) {
  const scene::Case scene = column(elastic, cell);
  std::vector<double> frequencies;
  for (double f = 0.25; f < 9.0; f += 0.05)
    frequencies.push_back(f);
  double wrong = 0.0;
  double largest = 0.0;
  for (const SurfaceTransfer& computed :
       surface_transfer(ground_from_case(scene, scene.profile), WaveType::SV, 0.0, frequencies)) {
    const auto expected = amplification(closed, computed.frequency_hz);
    wrong = std::max(wrong, std::abs(computed.to_outcrop - expected));
    largest = std::max(largest, std::abs(expected));
  }
  EXPECT_GT(largest, 4.0) << "the frequencies hold no resonance";
  return wrong / largest;
}

/// Errors on cells of 2, 1 and 0.5 m.
std::array<double, 3> errors(const std::string& elastic, const Closed& closed) {
  const std::array found = {error(elastic, 2.0, closed), error(elastic, 1.0, closed),
                            error(elastic, 0.5, closed)};
  std::printf("errors on cells of 2, 1, 0.5 m: %.2e %.2e %.2e\n", found[0], found[1], found[2]);
  return found;
}

TEST(StiffnessOverDepth, LinearModulusConvergesToSecondOrder) {
  constexpr double at_surface = 20e6; // G, Pa
  constexpr double at_base = 140e6;
  constexpr double b = (at_base - at_surface) / depth;
  constexpr double c = at_surface / b;
  const Closed closed = [](double omega, double z) -> Shape {
    const auto x = [omega](double down) { return 2.0 * omega * std::sqrt(density * (down + c) / b); };
    const double j = std::cyl_neumann(1.0, x(0.0));
    const double y = -std::cyl_bessel_j(1.0, x(0.0));
    // dx/dz = x/(2 (z + c)), J_0' = -J_1
    return {j * std::cyl_bessel_j(0.0, x(z)) + y * std::cyl_neumann(0.0, x(z)),
            -0.5 * b * x(z) * (j * std::cyl_bessel_j(1.0, x(z)) + y * std::cyl_neumann(1.0, x(z)))};
  };
  // E = 2 (1 + nu) G
  const auto [coarse, middle, fine] =
      errors(fmt::format("young = {{ depth = [0.0, {}], value = [{}, {}] }}\npoisson = 0.25\n", depth,
                         2.5 * at_surface, 2.5 * at_base),
             closed);
  EXPECT_LT(fine, 4e-3);
  EXPECT_GT(std::log2(coarse / middle), 1.8);
  EXPECT_GT(std::log2(middle / fine), 1.8);
}

TEST(StiffnessOverDepth, ModulusByTheRootOfStressConverges) {
  constexpr double reference = 180.0; // m/s at 100 kPa
  constexpr double m = 0.5;           // v_s grows with the fourth root of stress
  constexpr double q = (1.0 - m) / (2.0 - m);
  constexpr double p = 0.5 * (2.0 - m);
  const double g = density * reference * reference * std::pow(density * 9.81 / 100e3, m);
  const auto bessel = [](double order, double x) { // J_-order
    return std::cos(order * std::numbers::pi) * std::cyl_bessel_j(order, x) -
           std::sin(order * std::numbers::pi) * std::cyl_neumann(order, x);
  };
  const Closed closed = [=](double omega, double z) -> Shape {
    const double k = omega * std::sqrt(density / g) / p;
    if (z == 0.0)
      return {std::pow(2.0, q) / std::tgamma(1.0 - q), 0.0};
    const double x = k * std::pow(z, p);
    return {std::pow(x, q) * bessel(q, x), -g * std::pow(z, m) * std::pow(x, q) *
                                               std::cyl_bessel_j(1.0 - q, x) * k * p * std::pow(z, p - 1.0)};
  };
  const auto [coarse, middle, fine] =
      errors(fmt::format("vs = {{ reference = {}, stress = 100e3, exponent = 0.25 }}\n"
                         "vp = {{ reference = {}, stress = 100e3, exponent = 0.25 }}\n",
                         reference, 2.0 * reference),
             closed);
  EXPECT_LT(fine, 1e-2);
  EXPECT_GT(std::log2(coarse / middle), 1.6);
  EXPECT_GT(std::log2(middle / fine), 1.6);
}

} // namespace
} // namespace tremolo::wavefield
