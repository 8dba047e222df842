// One element on a rigid base is an oscillator, w^2 = 2 G/(rho h^2). Hilber, Hughes and Taylor's method makes
// of its free motion a sequence with a three-step recurrence that follows from the definition by eliminating
// velocities, W = w dt, b = (1 - alpha)^2/4, g = 1/2 - alpha:
//
//     [1 + W^2 b (1+alpha)] u_{n+1} + [-2 + W^2 ((1/2 - 2b + g)(1+alpha) - b alpha)] u_n
//     + [1 + W^2 ((1/2 + b - g)(1+alpha) - (1/2 - 2b + g) alpha)] u_{n-1} - W^2 alpha (1/2 + b - g) u_{n-2} =
//     0.
//
// The largest root is the spectral radius: 1 for alpha = 0, (1 + alpha)/(1 - alpha) for infinite W.

#include "freefield/fe/fe_column.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::LinearElastic;

/// Coefficients of u_{n-2} ... u_{n+1}.
std::array<double, 4> recurrence(double alpha, double w_dt) {
  const double w2 = w_dt * w_dt;
  const double b = 0.25 * (1.0 - alpha) * (1.0 - alpha);
  const double g = 0.5 - alpha;
  return {-w2 * alpha * (0.5 + b - g),
          1.0 + w2 * ((0.5 + b - g) * (1.0 + alpha) - (0.5 - 2.0 * b + g) * alpha),
          -2.0 + w2 * ((0.5 - 2.0 * b + g) * (1.0 + alpha) - b * alpha), 1.0 + w2 * b * (1.0 + alpha)};
}

double spectral_radius(double alpha, double w_dt) {
  const auto c = recurrence(alpha, w_dt);
  Eigen::Matrix3d companion = Eigen::Matrix3d::Zero();
  companion(1, 0) = companion(2, 1) = 1.0;
  for (int i = 0; i < 3; ++i) {
    companion(i, 2) = -c[static_cast<std::size_t>(i)] / c[3];
  }
  return companion.eigenvalues().cwiseAbs().maxCoeff();
}

/// Displacement and energy of an oscillator with w dt given, after a jolt of its base.
struct Free {
  std::vector<double> displacement;
  std::vector<double> energy;
};

Free free_motion(double alpha, double w_dt, bool with_law, std::size_t steps) {
  const Elasticity soil = Elasticity::from_wave_speeds(2000.0, 100.0, 200.0);
  const Layer layer = with_law ? layer_of(1.0, LinearElastic{soil}) : Layer{1.0, soil};
  const double dt = w_dt / (std::numbers::sqrt2 * 100.0);
  FeColumn column({.layers = {layer}, .half_space = soil},
                  {.max_element_size = 1.0,
                   .time_step = dt,
                   .base = BaseKind::rigid,
                   .hht_alpha = alpha,
                   .newton_tolerance = 1e-13},
                  [=](double t) {
                    return Velocity{t < 1.2 * dt ? std::sin(t / dt) : 0.0, 0.0};
                  });
  Free motion;
  const double surface = 0.0;
  const double base = -1.0;
  for (std::size_t i = 0; i < steps + 3; ++i) {
    column.step();
    ColumnSample top;
    ColumnSample bottom;
    column.sample({&surface, 1}, {&top, 1});
    column.sample({&base, 1}, {&bottom, 1});
    if (i >= 3) {
      motion.displacement.push_back(top.ux - bottom.ux);
      motion.energy.push_back(column.energy().kinetic + column.energy().strain);
    }
  }
  return motion;
}

TEST(HilberHughesTaylor, FollowsItsClosedForm) {
  for (const bool with_law : {false, true}) {
    for (const double alpha : {0.0, -0.05, -0.2, -1.0 / 3.0}) {
      for (const double w_dt : {0.3, 2.0, 20.0}) {
        const auto u = free_motion(alpha, w_dt, with_law, 40).displacement;
        const auto c = recurrence(alpha, w_dt);
        for (std::size_t n = 2; n + 1 < u.size(); ++n) {
          const double left = c[0] * u[n - 2] + c[1] * u[n - 1] + c[2] * u[n] + c[3] * u[n + 1];
          EXPECT_NEAR(left / c[3], 0.0, 1e-11 * std::abs(u[0])) << alpha << " " << w_dt << " " << n;
        }
      }
    }
  }
}

TEST(HilberHughesTaylor, DampsHighFrequenciesOnly) {
  for (const double alpha : {-0.05, -0.2, -1.0 / 3.0}) {
    EXPECT_NEAR(spectral_radius(alpha, 1e5), (1.0 + alpha) / (1.0 - alpha), 1e-3);
    EXPECT_GT(spectral_radius(alpha, 0.1), 0.999);
    const double w_dt = 10.0;
    const auto energy = free_motion(alpha, w_dt, true, 41).energy;
    const double rate = std::pow(energy[40] / energy[10], 1.0 / 60.0);
    EXPECT_NEAR(rate, spectral_radius(alpha, w_dt), 0.05) << alpha;
  }
}

TEST(AverageAcceleration, KeepsTheEnergyOfFreeMotion) {
  for (const bool with_law : {false, true}) {
    for (const double w_dt : {0.3, 2.0, 20.0}) {
      const auto energy = free_motion(0.0, w_dt, with_law, 1000).energy;
      EXPECT_NEAR(energy.back() / energy.front(), 1.0, 1e-10) << w_dt;
    }
  }
}

} // namespace
