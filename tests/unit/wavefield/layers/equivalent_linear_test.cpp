// The iteration against one written here for vertical shear waves alone: SHAKE's recursion of up- and
// downgoing amplitudes from layer to layer (Schnabel, Lysmer and Seed 1972), summed by direct Fourier sums.

#include "tests/support/layered_reference.hpp"
#include "wavefield/layers/equivalent_linear.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace tremolo::wavefield;
using Complex = std::complex<double>;

LayeredHalfSpace soft_ground() {
  return {.layers = {{.thickness = 4.0, .density = 1700.0, .vs = 120.0, .vp = 300.0, .damping = 0.02},
                     {.thickness = 6.0, .density = 1800.0, .vs = 180.0, .vp = 450.0, .damping = 0.02},
                     {.thickness = 10.0, .density = 1900.0, .vs = 260.0, .vp = 600.0, .damping = 0.02}},
          .half_space = {2100.0, 700.0, 1400.0},
          .half_space_damping = 0.01,
          .damping = {DampingModel::hysteretic}};
}

/// Hyperbolic reduction, damping that rises with it.
StrainCurves hyperbolic(double reference_strain) {
  return {[=](double strain) { return 1.0 / (1.0 + strain / reference_strain); },
          [=](double strain) {
            return 0.015 + 0.18 * (strain / reference_strain) / (1.0 + strain / reference_strain);
          }};
}

std::vector<StrainCurves> curves() {
  return {hyperbolic(8e-4), hyperbolic(1.1e-3), hyperbolic(1.5e-3)};
}

constexpr double dt = 0.01;

/// A modulated sum of sines, m/s2.
std::vector<double> shaking(double scale) {
  std::vector<double> acceleration(500);
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    const double t = dt * static_cast<double>(i);
    const double envelope = std::pow(std::sin(std::numbers::pi * t / 5.0), 2);
    acceleration[i] =
        scale * envelope * (std::sin(9.0 * t) + 0.7 * std::sin(23.0 * t + 1.0) + 0.3 * std::sin(51.0 * t));
  }
  return acceleration;
}

/// Largest strain at mid-depth of each layer by SHAKE's recursion on a window of 1000 samples.
std::vector<double> strains_by_shake(const LayeredHalfSpace& ground,
                                     const std::vector<double>& acceleration) {
  const std::size_t length = 2 * acceleration.size();
  const std::size_t layers = ground.layers.size();
  std::vector<std::vector<Complex>> strain(layers, std::vector<Complex>(length / 2 + 1));
  for (std::size_t k = 1; k <= length / 2; ++k) {
    const double w = 2.0 * std::numbers::pi * static_cast<double>(k) / (static_cast<double>(length) * dt);
    Complex input = 0.0;
    for (std::size_t j = 0; j < acceleration.size(); ++j) {
      input += acceleration[j] * std::polar(1.0, -w * dt * static_cast<double>(j));
    }
    // E up, F down at the top of each layer, from a unit surface amplitude.
    std::vector<Complex> e{1.0};
    std::vector<Complex> f{1.0};
    std::vector<Complex> wave_number;
    for (std::size_t j = 0; j < layers; ++j) {
      const auto impedance = [&](std::size_t i) {
        const bool soil = i < layers;
        const double density = soil ? ground.layers[i].density : ground.half_space.density;
        const double vs = soil ? ground.layers[i].vs : ground.half_space.vs;
        const double xi = soil ? ground.layers[i].damping : ground.half_space_damping;
        return density * vs * std::sqrt(Complex(1.0, 2.0 * xi));
      };
      const Layer& layer = ground.layers[j];
      const Complex kh = w / (layer.vs * std::sqrt(Complex(1.0, 2.0 * layer.damping))) * layer.thickness;
      const Complex up = e[j] * std::exp(Complex(0.0, 1.0) * kh);
      const Complex down = f[j] * std::exp(Complex(0.0, -1.0) * kh);
      const Complex ratio = impedance(j) / impedance(j + 1);
      e.push_back(0.5 * (up * (1.0 + ratio) + down * (1.0 - ratio)));
      f.push_back(0.5 * (up * (1.0 - ratio) + down * (1.0 + ratio)));
      wave_number.push_back(kh / layer.thickness);
    }
    for (std::size_t j = 0; j < layers; ++j) {
      // u = E exp(i k z) + F exp(-i k z), z downwards: strain i k (E exp - F exp) at mid-depth, times
      // u = -a/w^2.
      const Complex i_kz = Complex(0.0, 0.5) * wave_number[j] * ground.layers[j].thickness;
      strain[j][k] = Complex(0.0, 1.0) * wave_number[j] * (e[j] * std::exp(i_kz) - f[j] * std::exp(-i_kz)) /
                     e.back() * (-input / (w * w));
    }
  }
  std::vector<double> largest(layers);
  for (std::size_t j = 0; j < layers; ++j) {
    for (std::size_t i = 0; i < length; ++i) {
      double sum = 0.0;
      for (std::size_t k = 1; k <= length / 2; ++k) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i * k % length) / static_cast<double>(length);
        sum += (2 * k == length ? 1.0 : 2.0) * (strain[j][k] * std::polar(1.0, angle)).real();
      }
      largest[j] = std::max(largest[j], std::abs(sum) / static_cast<double>(length));
    }
  }
  return largest;
}

TEST(EquivalentLinear, IterationIsThatOfShake) {
  const auto acceleration = shaking(1.0);
  const auto result = equivalent_linear(soft_ground(), curves(), WaveType::SV, 0.0, {acceleration, dt},
                                        {.max_iterations = 4, .allow_non_convergence = true});
  ASSERT_EQ(result.iterations.size(), 4U);
  LayeredHalfSpace ground = soft_ground();
  for (const EquivalentLinearIteration& iteration : result.iterations) {
    const auto strains = strains_by_shake(ground, acceleration);
    for (std::size_t j = 0; j < strains.size(); ++j) {
      EXPECT_NEAR(iteration.largest_strain[j] / strains[j], 1.0, 1e-9);
      const double effective = 0.65 * strains[j];
      ground.layers[j].vs = soft_ground().layers[j].vs * std::sqrt(curves()[j].modulus_reduction(effective));
      ground.layers[j].damping = curves()[j].damping(effective);
    }
  }
  for (std::size_t j = 0; j < ground.layers.size(); ++j) {
    EXPECT_NEAR(result.profile.layers[j].vs, ground.layers[j].vs, 1e-8 * ground.layers[j].vs);
    EXPECT_NEAR(result.profile.layers[j].damping, ground.layers[j].damping, 1e-8);
    EXPECT_LT(result.profile.layers[j].vs, 0.95 * soft_ground().layers[j].vs); // it did soften
  }
}

TEST(EquivalentLinear, EndsWhereStrainAndPropertiesBelongTogether) {
  for (const double degrees : {0.0, 20.0, 40.0}) {
    const auto acceleration = shaking(1.0);
    const EquivalentLinearOptions options{.tolerance = 1e-3, .max_iterations = 40};
    const auto result = equivalent_linear(soft_ground(), curves(), WaveType::SV,
                                          tremolo::testing::radians(degrees), {acceleration, dt}, options);
    // One more pass from the converged ground changes nothing.
    EquivalentLinearOptions once = options;
    once.max_iterations = 1;
    once.allow_non_convergence = true;
    LayeredHalfSpace small = soft_ground();
    for (std::size_t j = 0; j < small.layers.size(); ++j) {
      small.layers[j] = result.profile.layers[j];
    }
    const auto strains = equivalent_linear(small, curves(), WaveType::SV, tremolo::testing::radians(degrees),
                                           {acceleration, dt}, once)
                             .iterations.front()
                             .largest_strain;
    for (std::size_t j = 0; j < strains.size(); ++j) {
      const double reduction = std::pow(result.profile.layers[j].vs / soft_ground().layers[j].vs, 2);
      EXPECT_NEAR(curves()[j].modulus_reduction(0.65 * strains[j]) / reduction, 1.0, 2e-3) << degrees;
      // The bulk modulus stays, and its damping: rho c_p^2 = K + 4/3 G.
      const auto bulk = [](const Layer& layer) {
        return layer.vp * layer.vp - 4.0 / 3.0 * layer.vs * layer.vs;
      };
      const Layer before = soft_ground().layers[j];
      const Layer& after = result.profile.layers[j];
      EXPECT_NEAR(bulk(after) / bulk(before), 1.0, 1e-12);
      const double share = bulk(after) / (after.vp * after.vp);
      EXPECT_NEAR(*after.damping_p, share * before.damping + (1.0 - share) * after.damping, 1e-12);
    }
  }
}

TEST(EquivalentLinear, TakesNonConvergenceForAnErrorUnlessItIsAllowed) {
  const auto acceleration = shaking(1.5);
  EquivalentLinearOptions options{.tolerance = 1e-6, .max_iterations = 2};
  EXPECT_THAT(
      [&] {
        equivalent_linear(soft_ground(), curves(), WaveType::SV, 0.0, {acceleration, dt}, options);
      },
      ::testing::ThrowsMessage<NotConverged>(::testing::AllOf(
          ::testing::HasSubstr("has not converged after 2 iterations: modulus still changes by "),
          ::testing::HasSubstr(" m below the surface; allowed is 0.0001 %"))));
  options.allow_non_convergence = true;
  const auto result =
      equivalent_linear(soft_ground(), curves(), WaveType::SV, 0.0, {acceleration, dt}, options);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations.size(), 2U);
}

/// A hyperbola under Masing's rule, whose loops end at a damping ratio of 2/pi (Ishihara 1996, ch. 3):
/// xi = 4/pi (1 + 1/x) (1 - ln(1 + x)/x) - 2/pi,  x = gamma / gamma_ref.
StrainCurves masing(double reference_strain) {
  return {[=](double strain) { return 1.0 / (1.0 + strain / reference_strain); },
          [=](double strain) {
            const double x = strain / reference_strain;
            return x < 1e-4 ? 2.0 * x / (3.0 * std::numbers::pi)
                            : 4.0 / std::numbers::pi * (1.0 + 1.0 / x) * (1.0 - std::log1p(x) / x) -
                                  2.0 / std::numbers::pi;
          }};
}

TEST(EquivalentLinear, HoldsTheDampingOfMasingsRuleAndSaysWhere) {
  const auto acceleration = shaking(3.0);
  const std::vector soil{masing(2e-4), masing(2e-3), masing(4e-3)};
  const auto result = equivalent_linear(soft_ground(), soil, WaveType::SV, 0.0, {acceleration, dt});
  EXPECT_TRUE(result.converged);
  const auto& strains = result.iterations.back().largest_strain;
  EXPECT_GT(soil[0].damping(0.65 * strains[0]), 0.5); // Masing's rule asks for more than a modulus can have
  EXPECT_EQ(result.held_damping, std::vector<std::size_t>{0});
  EXPECT_EQ(result.profile.layers[0].damping, largest_damping);
  EXPECT_NEAR(result.profile.layers[1].damping, soil[1].damping(0.65 * strains[1]), 1e-12);
}

TEST(EquivalentLinear, RefusesWhatItCannotUse) {
  const auto acceleration = shaking(1.0);
  const auto refused = [&](auto change, const std::string& words) {
    LayeredHalfSpace ground = soft_ground();
    std::vector<StrainCurves> soil = curves();
    change(ground, soil);
    EXPECT_THAT(
        [&] {
          equivalent_linear(ground, soil, WaveType::SV, 0.0, {acceleration, dt});
        },
        ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr(words)));
  };
  refused([](auto&, auto& soil) { soil.pop_back(); }, "curves of 2 layers, must be 3");
  refused([](auto& ground, auto&) { ground.layers.clear(); }, "at least one layer");
  refused([](auto&, auto& soil) { soil[1].damping = [](double) { return 1.2; }; },
          "damping ratio of the soil from 4 m to 10 m below the surface at a strain of");
  refused([](auto&, auto& soil) { soil[0].modulus_reduction = [](double) { return std::nan(""); }; },
          "G/Gmax of the soil from 0 m to 4 m below the surface");
  EXPECT_THROW(equivalent_linear(soft_ground(), curves(), WaveType::SV, 0.0, {acceleration, 0.0}),
               std::invalid_argument);
}

} // namespace
