// Soil that turns, is pulled apart or sheared far.

#include "free_block.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double young = 40e6; // Pa

/// Angular momentum about the origin that the particles bring to the grid, per metre, kg m/s.
double angular_momentum(Domain& domain) {
  scatter(domain, ScatterPart::motion);
  const Grid& grid = domain.grid;
  double sum = 0.0;
  for (int j = 0; j < grid.ny; ++j)
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t n = grid.index(i, j);
      sum += (grid.x0 + i * grid.h) * grid.momentum_y[n] - (grid.y0 + j * grid.h) * grid.momentum_x[n];
    }
  return sum;
}

struct Turning {
  double drift = 0.0;  ///< largest change of angular momentum over that at the start
  double stress = 0.0; ///< largest, Pa
};

/// A square of 2 m turns ten times about its centre.
Turning turn_ten_times(Transfer transfer, StepOrder order) {
  static constexpr double omega = 0.4; // rad/s: rho omega^2 R^2 / E = 6.8e-6 at the middle of a side
  const auto make = [&](int threads) {
    Spec spec = elastic_box(2.0, 2.0, 0.5);
    spec.scheme.transfer = transfer;
    spec.scheme.order = order;
    spec.scheme.fraction = 1.0;
    return free_scene(spec, threads, [](Domain& domain) {
      set_velocity(domain, [](double x, double y) { return Vector{-omega * (y + 1.0), omega * (x - 1.0)}; });
      for (Particles& p : domain.sets)
        if (!p.cxx.empty()) {
          p.cxy.assign(p.size(), -omega);
          p.cyx.assign(p.size(), omega);
        }
    });
  };
  Scene probe = make(1);
  const double start = angular_momentum(*probe.domain);
  Turning result;
  double next = 0.0;
  run_monitored(make, {.speed = 2.0 * omega}, at_time(20.0 * std::numbers::pi / omega),
                [&](Domain& d, const Stepper& s) {
                  if (s.steps() % 100 != 0)
                    return;
                  result.drift = std::max(result.drift, std::abs(angular_momentum(d) / start - 1.0));
                  result.stress = std::max(result.stress, largest_stress(d));
                  if (std::getenv("SHOW") && s.time() > next) {
                    next += 5.0;
                    std::printf("%g %g %g %g\n", s.time(), angular_momentum(d) / start - 1.0, largest_stress(d) / young, d.energy.kinetic);
                  }
                });
  return result;
}

TEST(HardCase05, ABlockTurnsTenTimesApic) {
  const Turning turning = turn_ten_times(Transfer::apic, StepOrder::musl);
  bounded("drift of angular momentum", turning.drift, 1e-10);
  bounded("largest stress over E", turning.stress / young, 1e-5);
}

TEST(HardCase05, ABlockTurnsTenTimesFlip) {
  const Turning turning = turn_ten_times(Transfer::flip, StepOrder::usl);
  bounded("drift of angular momentum", turning.drift, 0.02);
}
TEST(HardCase05, ABlockTurnsTenTimesFlipM) {
  const Turning turning = turn_ten_times(Transfer::flip, StepOrder::musl);
  bounded("drift of angular momentum", turning.drift, 0.02);
}
TEST(HardCase05, ABlockTurnsTenTimesFlipF) {
  const Turning turning = turn_ten_times(Transfer::flip, StepOrder::usf);
  bounded("drift of angular momentum", turning.drift, 0.02);
}

} // namespace
} // namespace tremolo
