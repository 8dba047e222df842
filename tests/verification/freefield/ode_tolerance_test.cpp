// What a tolerance buys: the error in time of the column by the method of lines, against the same equations
// at a tolerance far tighter, on one grid; and that serving a column more often changes nothing.

#include "freefield/ode/ode_column.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;

enum class Soil { elastic, cyclic };

/// Three cycles that yield and reverse everywhere, at different times: gamma up to some 3 gamma_r.
Velocity cycles(double t) {
  const double envelope = t <= 0.0 || t >= 1.5 ? 0.0 : std::pow(std::sin(std::numbers::pi * t / 1.5), 2);
  return {0.1 * envelope * std::sin(2.0 * std::numbers::pi * 2.0 * t), 0.0};
}

constexpr double interval = 0.01;

std::vector<double> surface_velocity(Soil soil, OdeMethod method, double tolerance, int served_each = 1) {
  const auto elastic = Elasticity::from_wave_speeds(1800.0, 150.0, 300.0);
  Layer layer{20.0, elastic, 0.01};
  if (soil == Soil::cyclic) {
    layer.law = MasingShear{elastic, 5e-4, 1.0, 0.919};
  }
  OdeColumnSettings settings;
  settings.max_cell_size = 1.0;
  settings.time_step = interval / served_each;
  settings.method = method;
  settings.relative_tolerance = tolerance;
  settings.absolute_tolerance = 0.01 * tolerance;
  settings.damping = KelvinVoigtDamping{2.0};
  OdeColumn column({.layers = {layer}, .half_space = Elasticity::from_wave_speeds(2200.0, 600.0, 1200.0)},
                   settings, cycles);
  std::vector<double> history;
  for (int i = 0; i < 200; ++i) {
    for (int k = 0; k < served_each; ++k) {
      column.step();
    }
    const double surface = 0.0;
    ColumnSample sample;
    column.sample({&surface, 1}, {&sample, 1});
    history.push_back(sample.vx);
  }
  return history;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0, peak = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
    peak = std::max(peak, std::abs(b[i]));
  }
  return largest / peak;
}

struct Method {
  OdeMethod method;
  const char* name;
};
constexpr std::array<Method, 4> methods = {{{OdeMethod::adams, "adams"},
                                            {OdeMethod::bdf, "bdf"},
                                            {OdeMethod::explicit_runge_kutta, "erk"},
                                            {OdeMethod::imex, "imex"}}};

std::vector<double> ladder(Soil soil, const Method& method, const std::vector<double>& reference,
                           std::initializer_list<double> tolerances, double largest_in_tolerances) {
  std::vector<double> errors;
  std::printf("%-5s", method.name);
  for (const double tolerance : tolerances) {
    errors.push_back(largest_difference(surface_velocity(soil, method.method, tolerance), reference));
    std::printf("  %.0e: %.2e", tolerance, errors.back());
    EXPECT_LT(errors.back(), largest_in_tolerances * tolerance) << method.name;
  }
  std::printf("\n");
  return errors;
}

TEST(OdeColumnTolerance, ErrorFollowsItOverFiveDecadesInElasticSoil) {
  const auto reference = surface_velocity(Soil::elastic, OdeMethod::adams, 1e-12);
  for (const Method& method : methods) {
    const auto errors = ladder(Soil::elastic, method, reference, {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}, 20.0);
    for (std::size_t i = 1; i < errors.size(); ++i) {
      EXPECT_LT(errors[i], 0.9 * errors[i - 1]) << method.name << i;
    }
  }
}

TEST(OdeColumnTolerance, ErrorFollowsItUnderCyclesOfNonlinearSoil) {
  const auto reference = surface_velocity(Soil::cyclic, OdeMethod::explicit_runge_kutta, 1e-11);
  for (const Method& method : methods) {
    const auto errors = ladder(Soil::cyclic, method, reference, {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}, 20.0);
    for (std::size_t i = 1; i < errors.size(); ++i) {
      EXPECT_LT(errors[i], errors[i - 1]) << method.name << i;
    }
  }
}

TEST(OdeColumnTolerance, ServingSevenTimesAsOftenChangesNothing) {
  for (const Method& method : methods) {
    const auto seldom = surface_velocity(Soil::cyclic, method.method, 1e-4);
    const auto often = surface_velocity(Soil::cyclic, method.method, 1e-4, 7);
    EXPECT_LT(largest_difference(often, seldom), 1e-12)
        << method.name; // the same steps; times differ by rounding
  }
}

} // namespace
