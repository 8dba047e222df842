// What steps of their own for the levels of a graded mesh save, in CPU time: a slope of 10 m on three levels,
// 1 m to 0.25 m around its face, against the same step for all. Counters of levels/<c>:
//
//   ideal     sum N_l 2^L / sum N_l 2^l, with N_l particles in cells of level l of L
//   updates   the same of the clocks that particles run on, buffers included
//   speed_up  measured: simulated time a second of CPU over that of the single step

#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

namespace tremolo::cost {
namespace {

mpm_domain::Spec slope(bool subcycle) {
  mpm_domain::Spec spec;
  spec.box = {0.0, -30.0, 100.0, 10.0};
  spec.cell_size = 1.0;
  spec.refine = {{{34.0, -5.0, 58.0, 10.0}, 1}, {{38.0, -2.0, 52.0, 10.0}, 2}};
  spec.soils = {{"soil", materials::LinearElastic{{1700.0, 40e6, 0.28}}}};
  spec.regions = {{0, {{0.0, -30.0}, {100.0, -30.0}, {100.0, 10.0}, {50.0, 10.0}, {40.0, 0.0}, {0.0, 0.0}}}};
  spec.scheme.subcycle = subcycle;
  return spec;
}

class Shaken {
public:
  explicit Shaken(bool subcycle)
      : domain_(slope(subcycle)), stepper_(started(domain_), 0.0, test_support::quiet_ground()) {}

  const mpm_domain::Domain& domain() const { return domain_; }
  const mpm_domain::Stepper& stepper() const { return stepper_; }

  /// CPU seconds for a simulated time, s.
  double run(double time) {
    const std::clock_t start = std::clock();
    const double end = stepper_.time() + time;
    while (stepper_.time() < end)
      stepper_.step();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }

private:
  static mpm_domain::Domain& started(mpm_domain::Domain& domain) {
    for (mpm_domain::Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k)
        set.vx[k] = 0.01 * std::sin(0.1 * set.y[k]);
    return domain;
  }

  mpm_domain::Domain domain_;
  mpm_domain::Stepper stepper_;
};

double ideal_speed_up(const mpm_domain::Domain& domain) {
  double all = 0.0;
  double steps = 0.0;
  for (const mpm_domain::Particles& set : domain.sets) {
    all += static_cast<double>(set.size());
    steps += static_cast<double>(set.size()) * std::exp2(set.level);
  }
  return all * std::exp2(domain.lattice_count() - 1) / steps;
}

void levels(benchmark::State& state) {
  Shaken single(false);
  Shaken subcycled(true);
  const double time = 20.0 * subcycled.stepper().dt();
  single.run(0.25 * time);
  subcycled.run(0.25 * time);
  double single_seconds = 0.0;
  double subcycled_seconds = 0.0;
  for (auto _ : state) {
    single_seconds += single.run(time);
    subcycled_seconds += subcycled.run(time);
  }
  const double per_step =
      subcycled.stepper().particle_updates() / static_cast<double>(subcycled.stepper().steps());
  const auto particles = static_cast<double>(subcycled.domain().particle_count());
  state.counters["particles"] = particles;
  state.counters["ideal"] = ideal_speed_up(subcycled.domain());
  state.counters["updates"] = particles * std::exp2(subcycled.domain().clocks.count() - 1) / per_step;
  state.counters["speed_up"] = single_seconds / subcycled_seconds;
}
BENCHMARK(levels)->Unit(benchmark::kMillisecond)->Iterations(3);

} // namespace
} // namespace tremolo::cost
