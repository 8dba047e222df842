// A million random increments of strain and rotation on random sands: nothing is lost, nothing leaves its
// bounds, and what is dissipated is less than the work done.

#include "tests/support/pm4sand_bounds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

namespace tremolo::materials::test {
namespace {

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Pm4Sand random_sand(std::mt19937_64& random) {
  Pm4SandInput input;
  input.density = 1900.0;
  input.relative_density = between(random, 0.05, 1.2);
  input.G_o = between(random, 200.0, 1500.0);
  input.h_po = std::exp(between(random, std::log(0.02), std::log(20.0)));
  input.phi_cv = between(random, 0.4, 0.7);
  input.poisson = between(random, 0.05, 0.45);
  input.n_b = between(random, 0.1, 1.0);
  input.n_d = between(random, 0.0, 0.5);
  input.post_shake = random() % 4 == 0;
  return pm4sand(input);
}

PointStress random_stress(std::mt19937_64& random) {
  const double sv = std::exp(between(random, std::log(0.2), std::log(2000.0))) * kilopascal;
  return geostatic(sv, between(random, 0.3, 2.0), between(random, -0.3, 0.3) * sv);
}

/// What a step can dissipate if stress and strain agree in sign all the way, J/m3.
double largest_work(const PointStress& before, const PointStress& after, const PointStep& step) {
  const auto product = [](double a, double b, const Control& strain) {
    return (std::abs(a) + std::abs(b)) * std::abs(strain.value());
  };
  return product(before.xx, after.xx, step.xx) + product(before.yy, after.yy, step.yy) +
         product(before.xy, after.xy, step.xy);
}

constexpr int steps_per_run = 10000; // of 100 runs

RC_GTEST_PROP(Pm4Random, AnyPathStaysWithinTheBounds, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const Pm4Sand law = random_sand(random);
  PointTest point(law, random_stress(random));
  // The elastic energy of the initial stress can be dissipated as well: sigma^2/G, G lowered eight times at
  // most by stress ratio, fabric and sedimentation on the way to a soil without stress.
  const PointStress start = point.stress();
  const double squares = start.xx * start.xx + start.yy * start.yy + 2.0 * start.xy * start.xy;
  const double p = -0.5 * (start.xx + start.yy);
  double throughput = 8.0 * squares / (law.G_o * std::sqrt(law.p_A * p));
  PointStep step;
  for (int n = 0; n < steps_per_run; ++n) {
    if (n % 20 == 0) { // a new direction now and then
      const double size = std::exp(between(random, std::log(1e-9), std::log(3e-5)));
      const double volume = 0.3 * size * between(random, -1.0, 1.0);
      const double stretch = size * between(random, -1.0, 1.0);
      step = {Control::strain(volume + stretch), Control::strain(volume - stretch),
              Control::strain(size * between(random, -2.0, 2.0)), size * between(random, -100.0, 100.0)};
    }
    PointStep taken = step;
    if (random() % 500 == 0) { // and a jolt
      taken.xy = Control::strain(between(random, -2e-3, 2e-3));
    }
    const PointStress before = point.stress();
    point.apply(taken);
    throughput += largest_work(before, point.stress(), taken);
    RC_ASSERT(broken_bound(law, point) == "");
  }
  RC_ASSERT(point.plastic_work() > -0.05 * throughput);
  RC_ASSERT(point.plastic_work() < throughput);
}

/// Increments up to 2 per cent in any direction, each from where the last one led: every one of them ends,
/// from 1 kPa to 1 MPa, at the floor of the pressure, and with a gap open or closing. (A million by hand.)
TEST(Pm4Random, AnyLargeIncrementEnds) {
  std::mt19937_64 random(5);
  for (const int density : {35, 55, 75}) {
    const Pm4Sand law = report_sand(density);
    int apart = 0;
    for (int path = 0; path < 20; ++path) {
      const double sv = std::exp(between(random, std::log(1.0), std::log(1000.0))) * kilopascal;
      PointTest point(law, geostatic(sv, between(random, 0.4, 1.5)));
      for (int n = 0; n < 40; ++n) {
        const double size = 0.02 * between(random, 0.0, 1.0);
        const double volume = 0.5 * size * between(random, -1.0, 1.0);
        const double stretch = 0.5 * size * between(random, -1.0, 1.0);
        point.apply({Control::strain(volume + stretch), Control::strain(volume - stretch),
                     Control::strain(size * between(random, -1.0, 1.0))});
        ASSERT_EQ(broken_bound(law, point), "") << density << " " << path << " " << n;
        apart += pm4::load(point.state().data()).now.gap > 0.0 ? 1 : 0;
      }
    }
    EXPECT_GT(apart, 50);
  }
}

} // namespace
} // namespace tremolo::materials::test
