// Order of the finite-element column against exact responses of a uniform and of a two-layer column to a
// pulse that comes in with both polarisations: all quantities a source serves, at nodes and between them.

#include "freefield/twophase/two_phase_column.hpp"
#include "tests/support/layered_column.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::testing::LayeredColumn;

constexpr double pulse_frequency = 3.0;
constexpr double pulse_time = 0.5;
constexpr double duration = 2.0;
constexpr double exchange_step = 0.02;
/// Peak velocity of the pulse, m/s. It is so small that elements hardly change their length, which the exact
/// column keeps.
constexpr double amplitude = 1e-4;

double pulse(double t) {
  const double a = std::pow(std::numbers::pi * pulse_frequency * (t - pulse_time), 2);
  return (1.0 - 2.0 * a) * std::exp(-a);
}

Profile uniform() {
  return {.surface_level = 5.0,
          .layers = {{30.0, Elasticity::from_wave_speeds(1800.0, 200.0, 400.0), 0.02}},
          .half_space = Elasticity::from_wave_speeds(2200.0, 800.0, 1600.0)};
}

Profile two_layers() {
  return {.surface_level = 0.0,
          .layers = {{8.0, Elasticity::from_wave_speeds(1700.0, 150.0, 320.0), 0.03},
                     {22.0, Elasticity::from_wave_speeds(1900.0, 300.0, 560.0), 0.01}},
          .half_space = Elasticity::from_wave_speeds(2200.0, 800.0, 1500.0)};
}

/// The base below rock that has no damping.
Profile rock_below() {
  Profile profile = two_layers();
  profile.layers[1].thickness = 10.0;
  profile.layers.push_back({12.0, profile.half_space, 0.0});
  return profile;
}

/// The exact column of one polarisation.
LayeredColumn exact(const Profile& profile, const Damping& damping, double (Elasticity::*modulus)() const) {
  std::vector<tremolo::testing::ScalarLayer> layers;
  for (const Layer& layer : profile.layers) {
    const DampingCoefficients c = coefficients(damping, layer.damping_ratio);
    layers.push_back({layer.thickness, layer.soil.density, (layer.soil.*modulus)(), c.alpha, c.beta});
  }
  const Elasticity& base = profile.half_space;
  return {layers, std::sqrt(base.density * (base.*modulus)()), pulse_frequency, pulse_time};
}

/// Depths at nodes, between nodes, at the surface, at the interface of two_layers and at the base.
constexpr std::array<double, 8> depths = {0.0, 0.3, 3.0, 7.9, 8.0, 15.2, 29.7, 30.0};

/// vx, vy, sxx, syy, sxy and their rates, as the largest error over depths and times relative to the peak.
using Errors = std::array<double, 10>;

std::array<double, 10> values(const ColumnSample& s) {
  return {s.vx, s.vy, s.sxx, s.syy, s.sxy, s.vx_rate, s.vy_rate, s.sxx_rate, s.syy_rate, s.sxy_rate};
}

class Exact {
public:
  Exact(const Profile& profile, const Damping& damping) {
    for (std::size_t i = 1; exchange_step * static_cast<double>(i) <= duration; ++i) {
      times_.push_back(exchange_step * static_cast<double>(i));
    }
    const auto shear = exact(profile, damping, &Elasticity::shear_modulus);
    const auto dilation = exact(profile, damping, &Elasticity::p_modulus);
    for (const double depth : depths) {
      const auto x = shear.at(depth, times_);
      const auto y = dilation.at(depth, times_);
      const Layer& layer = layer_above(profile, depth);
      const double lateral = layer.soil.lame() / layer.soil.p_modulus();
      auto& histories = samples_.emplace_back();
      for (std::size_t i = 0; i < times_.size(); ++i) {
        histories.push_back({x[i].velocity, -0.5 * y[i].velocity, -0.5 * lateral * y[i].stress,
                             -0.5 * y[i].stress, x[i].stress, x[i].acceleration, -0.5 * y[i].acceleration,
                             -0.5 * lateral * y[i].stress_rate, -0.5 * y[i].stress_rate, x[i].stress_rate});
      }
    }
  }

  const std::vector<double>& times() const { return times_; }
  ColumnSample at(std::size_t depth, std::size_t time) const { return samples_[depth][time]; }

private:
  static const Layer& layer_above(const Profile& profile, double depth) {
    double bottom = 0.0;
    for (const Layer& layer : profile.layers) {
      bottom += layer.thickness;
      if (depth <= bottom) {
        return layer;
      }
    }
    return profile.layers.back();
  }

  std::vector<double> times_;
  std::vector<std::vector<ColumnSample>> samples_;
};

Errors errors_of(const Profile& profile, const TwoPhaseSettings& settings, const Exact& exact_column) {
  TwoPhaseColumn column(profile, settings, [](double t) {
    return Velocity{amplitude * pulse(t), -0.5 * amplitude * pulse(t)};
  });
  std::vector<double> levels;
  for (const double depth : depths) {
    levels.push_back(profile.surface_level - depth);
  }
  std::vector<ColumnSample> samples(levels.size());
  Errors error{};
  Errors peak{};
  for (std::size_t i = 0; i < exact_column.times().size(); ++i) {
    while (column.time() < exact_column.times()[i] - 0.5 * settings.time_step) {
      column.step();
    }
    column.sample(levels, samples);
    for (std::size_t d = 0; d < levels.size(); ++d) {
      const auto computed = values(samples[d]);
      const auto expected = values(exact_column.at(d, i));
      for (std::size_t q = 0; q < error.size(); ++q) {
        error[q] = std::max(error[q], std::abs(computed[q] / amplitude - expected[q]));
        peak[q] = std::max(peak[q], std::abs(expected[q]));
      }
    }
  }
  for (std::size_t q = 0; q < error.size(); ++q) {
    error[q] /= peak[q];
  }
  return error;
}

constexpr std::array<const char*, 10> names = {"vx",      "vy",      "sxx",      "syy",      "sxy",
                                               "vx rate", "vy rate", "sxx rate", "syy rate", "sxy rate"};

/// Halves the elements, with the step that a case takes.
/// @param least_order  of all quantities
void expect_convergence(const Profile& profile, double size, const Damping& damping, double least_order,
                        double largest_error) {
  const Exact exact_column(profile, damping);
  const auto errors = [&](double element) {
    const double most = 0.8 * two_phase_step_limit(profile, element, damping);
    const double step = exchange_step / std::ceil(exchange_step / most);
    return errors_of(profile, {element, step, damping}, exact_column);
  };
  const Errors coarse = errors(size), fine = errors(size / 2.0);
  for (std::size_t q = 0; q < names.size(); ++q) {
    const double order = std::log2(coarse[q] / fine[q]);
    std::printf("%-8s %.2e %.2e order %.2f\n", names[q], coarse[q], fine[q], order);
    EXPECT_GT(order, least_order) << names[q];
    EXPECT_LT(fine[q], largest_error) << names[q];
  }
}

TEST(FeColumnConvergence, OfUndampedSoilIsOfSecondOrder) {
  Profile profile = two_layers();
  for (Layer& layer : profile.layers)
    layer.damping_ratio = 0.0;
  expect_convergence(profile, 0.5, KelvinVoigtDamping{3.0}, 1.8, 1e-3);
}

// Damping acts half a step late, which is of first order in the step; so is the step in the element where
// damping does not limit it, and of second order where it does.
TEST(FeColumnConvergence, OfDampedSoilIsBetweenFirstAndSecondOrder) {
  expect_convergence(uniform(), 1.0, KelvinVoigtDamping{5.0 / 3.0}, 1.7, 1e-3);
  expect_convergence(two_layers(), 0.5, RayleighDamping{1.0, 6.0}, 1.6, 1e-3);
  expect_convergence(rock_below(), 0.5, RayleighDamping{1.0, 6.0}, 0.95, 1e-3);
  expect_convergence(two_layers(), 1.0, KelvinVoigtDamping{3.0}, 1.6, 1e-3);
}

// It stiffens what moves with w by beta dt w^2/2, here by 0.8 %: with 10 % of damping and thirteen elements a
// wavelength.
TEST(FeColumnConvergence, DampingLagsByHalfAStep) {
  Profile profile = uniform();
  profile.layers[0].damping_ratio = 0.1;
  const KelvinVoigtDamping damping{pulse_frequency};
  const auto surface_velocity = [&](int steps_per_sample) {
    TwoPhaseColumn column(profile, {5.0, 4e-3 / steps_per_sample, damping}, [](double t) {
      return Velocity{amplitude * pulse(t), 0.0};
    });
    std::vector<double> history;
    for (int i = 0; i < 300; ++i) {
      for (int step = 0; step < steps_per_sample; ++step)
        column.step();
      ColumnSample sample;
      column.sample({&profile.surface_level, 1}, {&sample, 1});
      history.push_back(sample.vx);
    }
    return history;
  };
  const auto reference = surface_velocity(64);
  const double peak = std::ranges::max(reference);
  const auto error = [&](int steps_per_sample) {
    const auto history = surface_velocity(steps_per_sample);
    double largest = 0.0;
    for (std::size_t i = 0; i < history.size(); ++i)
      largest = std::max(largest, std::abs(history[i] - reference[i]));
    return largest / peak;
  };
  const double coarse = error(1), fine = error(2);
  std::printf("%.2e %.2e of the peak\n", coarse, fine);
  EXPECT_GT(std::log2(coarse / fine), 0.9);
  EXPECT_LT(coarse, 2e-2);
}

} // namespace
