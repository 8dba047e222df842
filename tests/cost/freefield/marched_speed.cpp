// CPU time of columns of 200 elements under 40 s of a wave at 15 degrees: MKZ soil without water, and PM4Sand
// with water that flows beside the vertical column. The argument is the duration in seconds.

#include "freefield/marched/marched_column.hpp"
#include "freefield/twophase/two_phase_column.hpp"
#include "tests/cost/freefield/mkz_column.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;

constexpr double angle = 15.0 * std::numbers::pi / 180.0;
const Elasticity rock = Elasticity::from_wave_speeds(2200.0, 760.0, 1520.0);
const double slowness = std::sin(angle) / rock.s_wave_speed();

/// 50 m of saturated sand, loose above and dense below.
Profile sand() {
  Profile profile{.half_space = rock, .gravity = 9.81, .water = WaterTable{0.0, {}}};
  const tremolo::materials::PoreSpace pores{0.42, 2650.0, 1e-4, tremolo::materials::Drainage::coupled};
  const double density = tremolo::materials::saturated_density(pores, {});
  for (const auto& [dr, stiffness, contraction] : {std::array{0.55, 677.0, 0.4}, {0.75, 890.0, 0.63}}) {
    Layer layer = layer_of(
        25.0, tremolo::materials::pm4sand(
                  {.density = density, .relative_density = dr, .G_o = stiffness, .h_po = contraction}));
    layer.damping_ratio = 0.005;
    layer.pores = pores;
    profile.layers.push_back(layer);
  }
  return profile;
}

template <class Made>
void march(benchmark::State& state, Made made) {
  while (state.KeepRunning()) {
    auto column = made();
    double largest_x = 0.0, largest_y = 0.0;
    const double surface = 0.0;
    long steps = 0;
    for (; column.time() < static_cast<double>(state.range(0)); ++steps) {
      column.step();
      if (steps % 8 == 0) {
        ColumnSample s;
        column.sample({&surface, 1}, {&s, 1});
        largest_x = std::max(largest_x, std::abs(s.vx));
        largest_y = std::max(largest_y, std::abs(s.vy));
      }
    }
    state.counters["steps"] = static_cast<double>(steps);
    state.counters["PGVx"] = largest_x;
    state.counters["PGVy"] = largest_y;
    if constexpr (requires { column.evaluations_per_step(); })
      state.counters["calls"] = column.evaluations_per_step();
    if constexpr (requires { column.unconverged_steps(); })
      state.counters["unconverged"] = static_cast<double>(column.unconverged_steps());
  }
}

MarchedColumn marched(const Profile& ground, double element, double peak, double growth) {
  const Damping damping = KelvinVoigtDamping{5.0};
  const double limit = marched_step_limit(ground, element, slowness, damping, growth);
  return {ground,
          {.max_element_size = element, .time_step = 0.9 * limit, .slowness_x = slowness, .damping = damping},
          strong_shaking(peak, angle)};
}

void mkz_vertical(benchmark::State& state) {
  march(state, [] {
    const double limit = two_phase_step_limit(mkz_profile(), 0.5, Damping{});
    return TwoPhaseColumn(mkz_profile(), {.max_element_size = 0.5, .time_step = 0.8 * limit},
                          strong_shaking(0.3));
  });
}

void mkz_marched(benchmark::State& state) {
  march(state, [] { return marched(mkz_profile(), 0.5, 0.3, 1.0); });
}

void pm4sand_vertical(benchmark::State& state) {
  march(state, [] {
    const Damping damping = KelvinVoigtDamping{5.0};
    const double limit = two_phase_step_limit(sand(), 0.25, damping, 2.0);
    return TwoPhaseColumn(sand(), {.max_element_size = 0.25, .time_step = 0.8 * limit, .damping = damping},
                          strong_shaking(0.1));
  });
}

void pm4sand_marched(benchmark::State& state) {
  march(state, [] { return marched(sand(), 0.25, 0.1, 2.0); });
}

BENCHMARK(mkz_vertical)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(mkz_marched)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(pm4sand_vertical)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(pm4sand_marched)->Arg(40)->Unit(benchmark::kMillisecond);

} // namespace
