// The reflectivity recursion against the assembled stiffness method, and where textbook propagators fail.

#include "tests/support/layered_reference.hpp"
#include "tests/support/stiffness_method.hpp"
#include "wavefield/layers/reflectivity.hpp"
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
using tremolo::testing::layered3;
using tremolo::testing::radians;
using tremolo::testing::SecondMethod;

/// Depths of surface and interfaces, the top of the half-space last.
std::vector<double> depths_of_faces(const LayeredHalfSpace& profile) {
  std::vector<double> depths{0.0};
  for (const Layer& layer : profile.layers) {
    depths.push_back(depths.back() + layer.thickness);
  }
  return depths;
}

/// Largest difference of the two methods' motions at all faces, over the largest motion.
double difference(const LayeredHalfSpace& profile, WaveType wave, double degrees, double frequency) {
  const std::array<double, 1> frequencies{frequency};
  const auto depths = depths_of_faces(profile);
  const auto recursion = transfer(profile, wave, radians(degrees), frequencies, depths).front();
  const auto stiffness = SecondMethod(profile, wave, radians(degrees), frequency).by_stiffness();
  double error = 0.0;
  double peak = 0.0;
  for (std::size_t j = 0; j < depths.size(); ++j) {
    error = std::max(
        {error, std::abs(recursion[j].ux - stiffness[j][0]), std::abs(recursion[j].uy - stiffness[j][1])});
    peak = std::max({peak, std::abs(stiffness[j][0]), std::abs(stiffness[j][1])});
  }
  return error / peak;
}

constexpr std::array models{DampingModel::none,         DampingModel::hysteretic,  DampingModel::shake,
                            DampingModel::kelvin_voigt, DampingModel::kjartansson, DampingModel::constant};

TEST(SecondMethod, AgreesForAllDampingModelsAndAngles) {
  double worst = 0.0;
  for (const DampingModel model : models) {
    const LayeredHalfSpace profile = layered3({model, 3.0});
    for (const WaveType wave : {WaveType::SV, WaveType::P}) {
      for (const double degrees : {0.0, 1e-7, 10.0, 20.0, 29.9, 31.0, 40.0, 60.0, 85.0}) {
        // 40 Hz would be a resonance of the first layer between fixed faces, where its stiffness has a pole.
        for (const double frequency : {0.05, 0.7, 3.0, 11.0, 41.0}) {
          const double error = difference(profile, wave, degrees, frequency);
          EXPECT_LT(error, 1e-10) << name(model) << " " << degrees << " deg " << frequency << " Hz";
          worst = std::max(worst, error);
        }
      }
    }
  }
  std::printf("recursion against assembled stiffness: %.1e\n", worst);
}

/// 700 m of soil whose P waves are evanescent under a shallow SV wave.
LayeredHalfSpace deep_soil() {
  return {.layers = {{.thickness = 20.0, .density = 1800.0, .vs = 250.0, .vp = 1500.0},
                     {.thickness = 180.0, .density = 1950.0, .vs = 450.0, .vp = 1800.0},
                     {.thickness = 500.0, .density = 2100.0, .vs = 700.0, .vp = 2200.0}},
          .half_space = {2400.0, 1000.0, 2500.0}};
}

TEST(SecondMethod, AgreesUnder700MetresOfEvanescentWavesWherePropagatorsFail) {
  double worst = 0.0;
  double naive = 0.0;
  for (const double frequency : {5.0, 10.0, 20.0, 30.0}) {
    const LayeredHalfSpace profile = deep_soil();
    worst = std::max(worst, difference(profile, WaveType::SV, 60.0, frequency));
    const SecondMethod second(profile, WaveType::SV, radians(60.0), frequency);
    const Eigen::Vector2cd right = second.by_stiffness().front();
    naive = std::max(naive, (second.by_naive_propagators() - right).norm() / right.norm());
  }
  std::printf("700 m, evanescent: recursion %.1e, propagators in double precision %.1e\n", worst, naive);
  EXPECT_LT(worst, 1e-10);
  EXPECT_GT(naive, 0.1); // no digit is left
  // It is not the propagators' theory: on 20 m they are right.
  const SecondMethod shallow(layered3({}), WaveType::SV, radians(20.0), 3.0);
  EXPECT_LT((shallow.by_naive_propagators() - shallow.by_stiffness().front()).norm(), 1e-10);
}

TEST(IdenticalLayers, AreTheHalfSpace) {
  double worst = 0.0;
  for (const DampingModel model : models) {
    const double ratio = model == DampingModel::none ? 0.0 : 0.04;
    const Layer slice{.thickness = 7.0, .density = 1700.0, .vs = 96.0, .vp = 174.0, .damping = ratio};
    const LayeredHalfSpace whole{
        .half_space = {1700.0, 96.0, 174.0}, .half_space_damping = ratio, .damping = {model, 3.0}};
    LayeredHalfSpace sliced = whole;
    sliced.layers = {slice, slice, slice};
    const std::array<double, 5> depths{0.0, 5.0, 7.0, 20.0, 30.0};
    const std::array<double, 3> frequencies{0.3, 3.0, 25.0};
    for (const WaveType wave : {WaveType::SV, WaveType::P}) {
      for (const double degrees : {0.0, 15.0, 33.0, 40.0, 75.0, 89.0}) {
        // The sliced one is referred to the top of its half-space, 21 m down.
        const auto a = transfer(sliced, wave, radians(degrees), frequencies, depths);
        const auto b = transfer(whole, wave, radians(degrees), frequencies, depths);
        Reflectivity reflectivity(whole, wave, radians(degrees));
        for (std::size_t i = 0; i < frequencies.size(); ++i) {
          const std::complex<double> s(0.0, 2.0 * std::numbers::pi * frequencies[i]);
          reflectivity.solve(s);
          const std::complex<double> to_reference = std::exp(s * reflectivity.incident_slowness() * -21.0);
          for (std::size_t d = 0; d < depths.size(); ++d) {
            const std::complex<double> ux = to_reference * b[i][d].ux;
            const std::complex<double> uy = to_reference * b[i][d].uy;
            const double scale = std::max({1.0, std::abs(ux), std::abs(uy)}); // damped waves grow downwards
            worst = std::max({worst, std::abs(a[i][d].ux - ux) / scale, std::abs(a[i][d].uy - uy) / scale});
          }
        }
      }
    }
  }
  std::printf("identical layers against half-space: %.1e\n", worst);
  EXPECT_LT(worst, 1e-11);
}

// Undamped layers store what comes in and give it back: at every depth the mean power upwards is zero, and in
// the half-space what goes down carries what came up.
TEST(EnergyFlux, Closes) {
  double worst = 0.0;
  for (const auto& profile : {layered3({}), deep_soil()}) {
    for (const WaveType wave : {WaveType::SV, WaveType::P}) {
      for (int step = 0; step < 128; ++step) {
        const double degrees = 0.1 + 0.7 * step;
        Reflectivity reflectivity(profile, wave, radians(degrees));
        for (const double frequency : {0.4, 2.7, 13.0}) {
          const auto& amplitudes = reflectivity.solve({0.0, 2.0 * std::numbers::pi * frequency});
          const WaveBasis& basis = reflectivity.basis(reflectivity.half_space());
          const auto flux = [](const Eigen::Vector4cd& state) {
            return 0.5 * (state[2] * std::conj(state[0]) + state[3] * std::conj(state[1])).real();
          };
          const double up = flux(basis.up * amplitudes.back().up);
          const double down = flux(basis.down * amplitudes.back().down);
          const Eigen::Vector4cd total =
              basis.up * amplitudes.back().up + basis.down * amplitudes.back().down;
          // Of the total field the evanescent P wave and the incident S wave have no mean power together.
          worst = std::max({worst, std::abs(up + down) / up, std::abs(flux(total)) / up});
        }
      }
    }
  }
  std::printf("energy flux: %.1e of the incident\n", worst);
  EXPECT_LT(worst, 1e-12);
}

} // namespace
