// Order of the finite-element column against exact responses of a uniform and of a two-layer column to a
// pulse that comes in with both polarisations: all quantities a source serves, at nodes and between them.

#include "freefield/fe/fe_column.hpp"
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

Errors errors_of(const Profile& profile, const FeColumnSettings& settings, const Exact& exact_column) {
  FeColumn column(profile, settings, [](double t) { return Velocity{pulse(t), -0.5 * pulse(t)}; });
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
        error[q] = std::max(error[q], std::abs(computed[q] - expected[q]));
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

/// Halves element and step together and expects errors to fall fourfold.
void expect_second_order(const Profile& profile, FeColumnSettings settings, double largest_error) {
  const Exact exact_column(profile, settings.damping);
  const Errors coarse = errors_of(profile, settings, exact_column);
  settings.max_element_size /= 2.0;
  settings.time_step /= 2.0;
  const Errors fine = errors_of(profile, settings, exact_column);
  for (std::size_t q = 0; q < names.size(); ++q) {
    const double order = std::log2(coarse[q] / fine[q]);
    std::printf("%-8s %.2e %.2e order %.2f\n", names[q], coarse[q], fine[q], order);
    EXPECT_GT(order, 1.8) << names[q];
    EXPECT_LT(fine[q], largest_error) << names[q];
  }
}

TEST(FeColumnConvergence, UniformKelvinVoigtByNewmark) {
  expect_second_order(uniform(), {0.5, 1e-3, Integrator::newmark, KelvinVoigtDamping{5.0 / 3.0}}, 3e-3);
}

TEST(FeColumnConvergence, UniformKelvinVoigtByCentralDifferences) {
  expect_second_order(uniform(), {1.0, 2e-4, Integrator::central_difference, KelvinVoigtDamping{5.0 / 3.0}},
                      3e-3);
}

TEST(FeColumnConvergence, TwoLayersRayleighByNewmark) {
  expect_second_order(two_layers(), {0.5, 1e-3, Integrator::newmark, RayleighDamping{1.0, 6.0}}, 3e-3);
}

TEST(FeColumnConvergence, TwoLayersRayleighByCentralDifferences) {
  expect_second_order(two_layers(), {0.5, 2e-4, Integrator::central_difference, RayleighDamping{1.0, 6.0}},
                      3e-3);
}

TEST(FeColumnConvergence, RayleighOverUndampedRock) {
  expect_second_order(rock_below(), {0.5, 1e-3, Integrator::newmark, RayleighDamping{1.0, 6.0}}, 3e-3);
}

TEST(FeColumnConvergence, TwoLayersKelvinVoigtByNewmark) {
  expect_second_order(two_layers(), {0.5, 1e-3, Integrator::newmark, KelvinVoigtDamping{3.0}}, 3e-3);
}

// On a fixed mesh with strong damping, where the step is limited by stability, a damping stress that lagged
// half a step behind would be first order in time. The second method is Newmark at a sixteenth of the step.
TEST(FeColumnConvergence, CentralDifferencesAreSecondOrderInTimeWithStiffnessDamping) {
  Profile profile = uniform();
  profile.layers[0].damping_ratio = 0.1;
  const KelvinVoigtDamping damping{5.0 / 3.0};
  const auto surface_velocity = [&](Integrator integrator, double dt) {
    FeColumn column(profile, {5.0, dt, integrator, damping}, [](double t) {
      return Velocity{pulse(t), 0.0};
    });
    std::vector<double> history;
    ColumnSample sample;
    const double surface = profile.surface_level;
    const auto steps = static_cast<int>(std::lround(1e-3 / dt));
    for (int i = 0; i < 1200; ++i) {
      for (int step = 0; step < steps; ++step) {
        column.step();
      }
      column.sample({&surface, 1}, {&sample, 1});
      history.push_back(sample.vx);
    }
    return history;
  };
  const auto reference = surface_velocity(Integrator::newmark, 1e-3 / 16.0);
  const auto error = [&](double dt) {
    const auto history = surface_velocity(Integrator::central_difference, dt);
    double largest = 0.0;
    for (std::size_t i = 0; i < history.size(); ++i) {
      largest = std::max(largest, std::abs(history[i] - reference[i]));
    }
    return largest;
  };
  EXPECT_GT(std::log2(error(1e-3) / error(5e-4)), 1.9);
}

} // namespace
