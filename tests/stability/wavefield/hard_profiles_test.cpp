// Angles and profiles at which plane-wave codes lose digits, each held to a number from a second method or an
// identity.

#include "tests/support/layered_reference.hpp"
#include "tests/support/stiffness_method.hpp"
#include "wavefield/layers/layered_field.hpp"
#include "wavefield/layers/reflectivity.hpp"
#include "wavefield/layers/transfer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::wavefield;
using tremolo::testing::layered3;
using tremolo::testing::radians;
using tremolo::testing::SecondMethod;

constexpr std::array frequencies{0.2, 1.0, 3.3, 9.1, 27.0};

std::vector<double> depths_of_faces(const LayeredHalfSpace& profile) {
  std::vector<double> depths{0.0};
  for (const Layer& layer : profile.layers) {
    depths.push_back(depths.back() + layer.thickness);
  }
  return depths;
}

/// Largest difference to the stiffness method at all faces and frequencies, over the largest motion.
double difference_to_stiffness(const LayeredHalfSpace& profile, WaveType wave, double angle) {
  const auto depths = depths_of_faces(profile);
  const auto recursion = transfer(profile, wave, angle, frequencies, depths);
  double worst = 0.0;
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const auto stiffness = SecondMethod(profile, wave, angle, frequencies[i]).by_stiffness();
    double error = 0.0;
    double peak = 0.0;
    for (std::size_t j = 0; j < depths.size(); ++j) {
      error = std::max({error, std::abs(recursion[i][j].ux - stiffness[j][0]),
                        std::abs(recursion[i][j].uy - stiffness[j][1])});
      peak = std::max({peak, std::abs(stiffness[j][0]), std::abs(stiffness[j][1])});
    }
    worst = std::max(worst, error / peak);
  }
  return worst;
}

/// Mean power at the top of the half-space over that of the incident wave; undamped layers pass none.
double energy_defect(const LayeredHalfSpace& profile, WaveType wave, double angle) {
  Reflectivity reflectivity(profile, wave, angle);
  double worst = 0.0;
  for (const double frequency : frequencies) {
    const auto& deep = reflectivity.solve({0.0, 2.0 * std::numbers::pi * frequency}).back();
    const WaveBasis& basis = reflectivity.basis(reflectivity.half_space());
    const auto flux = [](const Eigen::Vector4cd& state) {
      return 0.5 * (state[2] * std::conj(state[0]) + state[3] * std::conj(state[1])).real();
    };
    const double up = flux(basis.up * deep.up);
    worst = std::max(worst, std::abs(up + flux(basis.down * deep.down)) / up);
  }
  return worst;
}

/// Largest traction at the surface in time over rho vp times the largest velocity there.
double surface_traction(const LayeredHalfSpace& profile, WaveType wave, double angle) {
  const double deep = -profile.thickness();
  // The surface is free in any window; at grazing angles choosing one that holds all the ringing takes long.
  const LayeredField field(profile, {wave, angle, 0.0, deep}, 0.0, ricker(3.0, 1.0, 0.1), {.padding = 8.0});
  const Point surface{0.0, 0.0};
  const History h = field.sample({&surface, 1}, {0.0, 0.01, 400})[0];
  double velocity = 0.0;
  double traction = 0.0;
  for (std::size_t i = 0; i < h.vx.size(); ++i) {
    velocity = std::max({velocity, std::abs(h.vx[i]), std::abs(h.vy[i])});
    traction = std::max({traction, std::abs(h.sxy[i]), std::abs(h.syy[i])});
  }
  return traction / (velocity * profile.half_space.density * profile.half_space.vp);
}

TEST(Grazing, At89Point9Degrees) {
  const double angle = radians(89.9);
  for (const WaveType wave : {WaveType::SV, WaveType::P}) {
    EXPECT_LT(difference_to_stiffness(layered3({}), wave, angle), 1e-9);
    EXPECT_LT(difference_to_stiffness(layered3({DampingModel::hysteretic}), wave, angle), 1e-9);
    EXPECT_LT(energy_defect(layered3({}), wave, angle),
              1e-10); // of an incident power that is 600 times smaller
    EXPECT_LT(surface_traction(layered3({}), wave, angle), 1e-11);
  }
}

TEST(CriticalAngle, OfTheHalfSpaceExactlyAndNextToIt) {
  const double critical = std::asin(0.5); // of layered3: vs / vp = 500 / 1000
  for (const double angle : {critical, critical - 1e-9, critical + 1e-9}) {
    EXPECT_LT(energy_defect(layered3({}), WaveType::SV, angle), 1e-12);
    EXPECT_LT(surface_traction(layered3({}), WaveType::SV, angle), 1e-11);
  }
  // Across it the field changes with the square root of the distance.
  const std::array<double, 1> surface{0.0};
  const auto at = transfer(layered3({}), WaveType::SV, critical, frequencies, surface);
  for (const double side : {-1.0, 1.0}) {
    const auto near = transfer(layered3({}), WaveType::SV, critical + side * 1e-11, frequencies, surface);
    const auto farther = transfer(layered3({}), WaveType::SV, critical + side * 1e-9, frequencies, surface);
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      EXPECT_NEAR(std::abs(farther[i][0].ux - at[i][0].ux) / std::abs(near[i][0].ux - at[i][0].ux), 10.0,
                  0.1);
    }
  }
}

// Waves that run exactly along a layer: up- and downgoing are the same there. The field is smooth in the
// angle; 5e-5 rad to both sides the stiffness method has all its digits, and its mean is the field up to
// 1e-8.
void expect_smooth_across(const LayeredHalfSpace& profile, double critical) {
  const auto depths = depths_of_faces(profile);
  for (const double angle : {critical, critical - 1e-9, critical + 1e-9}) {
    EXPECT_LT(energy_defect(profile, WaveType::SV, angle), 1e-10);
    const auto recursion = transfer(profile, WaveType::SV, angle, frequencies, depths);
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      std::array<std::vector<Eigen::Vector2cd>, 4> near;
      for (std::size_t k = 0; k < near.size(); ++k) {
        constexpr std::array offsets{-1e-4, -5e-5, 5e-5, 1e-4};
        near[k] = SecondMethod(profile, WaveType::SV, critical + offsets[k], frequencies[i]).by_stiffness();
      }
      for (std::size_t j = 0; j < depths.size(); ++j) {
        // Of the cubic through the four: value in the middle, and slope from there to the angle.
        const Eigen::Vector2cd middle = (4.0 * (near[1][j] + near[2][j]) - (near[0][j] + near[3][j])) / 6.0;
        const Eigen::Vector2cd slope =
            (8.0 * (near[2][j] - near[1][j]) - (near[3][j] - near[0][j])) / (12.0 * 5e-5);
        const Eigen::Vector2cd expected = middle + slope * (angle - critical);
        EXPECT_LT(std::abs(recursion[i][j].ux - expected[0]), 2e-8 * (1.0 + std::abs(expected[0])));
        EXPECT_LT(std::abs(recursion[i][j].uy - expected[1]), 2e-8 * (1.0 + std::abs(expected[1])));
      }
    }
  }
}

TEST(CriticalAngle, OfALayersPWaves) {
  LayeredHalfSpace profile = layered3({});
  profile.layers[1].vp = 800.0;
  expect_smooth_across(profile, std::asin(500.0 / 800.0));
}

TEST(CriticalAngle, OfALayersShearWaves) {
  LayeredHalfSpace profile = layered3({});
  profile.layers[0].vs = 620.0;
  profile.layers[0].vp = 1300.0;
  expect_smooth_across(profile, std::asin(500.0 / 620.0));
}

TEST(CriticalAngle, OfALayersPWavesInTime) {
  LayeredHalfSpace profile = layered3({});
  profile.layers[0].vp = 800.0;
  profile.half_space.vp = 790.0; // the half-space is critical at 39.3 degrees, the layer at 38.7
  EXPECT_LT(surface_traction(profile, WaveType::SV, std::asin(500.0 / 800.0)), 1e-10);
}

// 10 m with Vs = 30 m/s on rock rings for minutes: impedances 48 and 3750. Vertical shear waves are a sum of
// echoes, v(t) = 2 T sum r^n f(t - (2 n + 1) h / Vs).
TEST(SoftLayer, TenMetresWithVs30OverRock) {
  const LayeredHalfSpace profile{.layers = {{.thickness = 10.0, .density = 1600.0, .vs = 30.0, .vp = 300.0}},
                                 .half_space = {2500.0, 1500.0, 2800.0}};
  const Signal pulse = ricker(3.0, 1.0, 0.1);
  const LayeredField field(profile, {WaveType::SV, 0.0, 0.0, -10.0}, 0.0, pulse);
  const Point surface{0.0, 0.0};
  const TimeGrid grid{0.0, 0.01, 2000};
  const History h = field.sample({&surface, 1}, grid)[0];
  const double soft = 1600.0 * 30.0;
  const double rock = 2500.0 * 1500.0;
  const double transmitted = 2.0 * rock / (soft + rock);
  const double echo = (soft - rock) / (soft + rock);
  double error = 0.0;
  double peak = 0.0;
  for (std::size_t i = 0; i < grid.count; ++i) {
    const double t = grid.dt * static_cast<double>(i);
    double exact = 0.0;
    for (int n = 0; n < 40; ++n) {
      exact += 2.0 * transmitted * std::pow(echo, n) * pulse.velocity(t - (2 * n + 1) * 10.0 / 30.0);
    }
    error = std::max(error, std::abs(h.vx[i] - exact));
    peak = std::max(peak, std::abs(exact));
  }
  EXPECT_LT(error / peak, 1e-8);
  EXPECT_LT(difference_to_stiffness(profile, WaveType::SV, radians(25.0)), 1e-9);
  EXPECT_LT(difference_to_stiffness(profile, WaveType::P, radians(60.0)), 1e-9);
  EXPECT_LT(energy_defect(profile, WaveType::SV, radians(25.0)), 1e-11);
}

TEST(VelocityInversion, SoftClayUnderAStiffCrust) {
  const LayeredHalfSpace profile{
      .layers = {{.thickness = 5.0, .density = 2000.0, .vs = 700.0, .vp = 1600.0},
                 {.thickness = 15.0, .density = 1600.0, .vs = 80.0, .vp = 1450.0},
                 {.thickness = 30.0, .density = 1900.0, .vs = 300.0, .vp = 1500.0}},
      .half_space = {2200.0, 500.0, 1800.0}};
  for (const double degrees :
       {0.0, 15.0, 44.0, 46.0, 70.0}) { // above 45.6 degrees the crust tunnels shear waves
    EXPECT_LT(difference_to_stiffness(profile, WaveType::SV, radians(degrees)), 1e-9) << degrees;
    EXPECT_LT(energy_defect(profile, WaveType::SV, radians(degrees)), 1e-11) << degrees;
  }
  EXPECT_LT(surface_traction(profile, WaveType::SV, radians(15.0)), 1e-11);
  EXPECT_LT(surface_traction(profile, WaveType::SV, radians(70.0)), 1e-11);
}

TEST(Incompressible, PoissonPoint499) {
  const double ratio = std::sqrt((2.0 - 2.0 * 0.499) / (1.0 - 2.0 * 0.499)); // vp / vs = 22.4
  LayeredHalfSpace profile = layered3({});
  for (Layer& layer : profile.layers) {
    layer.vp = layer.vs * ratio;
  }
  for (const double degrees : {0.0, 12.0, 31.0, 60.0}) {
    for (const WaveType wave : {WaveType::SV, WaveType::P}) {
      EXPECT_LT(difference_to_stiffness(profile, wave, radians(degrees)), 1e-9) << degrees;
      EXPECT_LT(energy_defect(profile, wave, radians(degrees)), 1e-11) << degrees;
    }
    EXPECT_LT(surface_traction(profile, WaveType::SV, radians(degrees)), 1e-11) << degrees;
  }
  profile.half_space.vp = profile.half_space.vs * ratio; // critical at 2.6 degrees
  EXPECT_LT(difference_to_stiffness(profile, WaveType::SV, radians(20.0)), 1e-9);
}

TEST(ThinLayer, OfAMillimetreIsHardlyThere) {
  LayeredHalfSpace profile = layered3({});
  const LayeredHalfSpace without = profile;
  profile.layers.insert(profile.layers.begin() + 1,
                        Layer{.thickness = 1e-3, .density = 1500.0, .vs = 100.0, .vp = 200.0});
  const std::array<double, 1> surface{0.0};
  const auto a = transfer(profile, WaveType::SV, radians(20.0), frequencies, surface);
  const auto b = transfer(without, WaveType::SV, radians(20.0), frequencies, surface);
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    // It adds a compliance of h/G and a mass of rho h: k h = 2 pi f h / Vs and amplified by the layers above.
    const double kh = 2.0 * std::numbers::pi * frequencies[i] * 1e-3 / 100.0;
    EXPECT_LT(std::abs(a[i][0].ux - b[i][0].ux), 20.0 * kh);
  }
  EXPECT_LT(energy_defect(profile, WaveType::SV, radians(20.0)), 1e-12);
}

} // namespace
