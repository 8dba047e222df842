// CPU time of columns of 200 elements under 40 s of a wave at 15 degrees: MKZ soil without water, and PM4Sand
// with water that flows beside the vertical column. The argument is the duration in seconds.

#include "freefield/marched/marched_column.hpp"
#include "freefield/twophase/two_phase_column.hpp"

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
using tremolo::materials::MasingShear;

constexpr double record_step = 5e-3;
constexpr double angle = 15.0 * std::numbers::pi / 180.0;
const Elasticity rock = Elasticity::from_wave_speeds(2200.0, 760.0, 1520.0);
const double slowness = std::sin(angle) / rock.s_wave_speed();

/// 100 m of soil whose wave speed grows with depth, ten layers of twenty elements.
Profile mkz() {
  Profile profile{.half_space = rock};
  for (int i = 0; i < 10; ++i) {
    const double vs = 180.0 + 20.0 * i;
    const Elasticity soil = Elasticity::from_wave_speeds(1900.0, vs, 2.0 * vs);
    profile.layers.push_back(
        layer_of(10.0, MasingShear{.elastic = soil, .reference_strain = 6e-4, .exponent = 0.919}));
  }
  return profile;
}

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

/// Strong shaking along a wave that comes in at an angle, linear between the samples of a record.
/// @param peak  m/s, at most
InputVelocity record(double peak, double incidence) {
  std::vector<double> samples;
  for (int i = 0; i * record_step <= 41.0; ++i) {
    const double t = i * record_step;
    const double envelope = peak * std::pow(t / 8.0, 2) * std::exp(2.0 * (1.0 - t / 8.0));
    samples.push_back(envelope * (std::sin(9.0 * t) + std::sin(23.0 * t + 1.0) + std::sin(41.0 * t)) / 3.0);
  }
  return [samples, c = std::cos(incidence), s = std::sin(incidence)](double t) {
    const double place = std::clamp(t / record_step, 0.0, static_cast<double>(samples.size() - 2));
    const auto i = static_cast<std::size_t>(place);
    const double v = std::lerp(samples[i], samples[i + 1], place - static_cast<double>(i));
    return Velocity{v * c, -v * s};
  };
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

MarchedColumn marched(const Profile& ground, double element, double peak) {
  const Damping damping = KelvinVoigtDamping{5.0};
  const double limit = marched_step_limit(ground, element, slowness, damping, 2.0);
  return {ground,
          {.max_element_size = element, .time_step = 0.9 * limit, .slowness_x = slowness, .damping = damping},
          record(peak, angle)};
}

void mkz_marched(benchmark::State& state) {
  march(state, [] { return marched(mkz(), 0.5, 0.3); });
}

void pm4sand_vertical(benchmark::State& state) {
  march(state, [] {
    const Damping damping = KelvinVoigtDamping{5.0};
    const double limit = two_phase_step_limit(sand(), 0.25, damping, 2.0);
    return TwoPhaseColumn(sand(), {.max_element_size = 0.25, .time_step = 0.8 * limit, .damping = damping},
                          record(0.1, 0.0));
  });
}

void pm4sand_marched(benchmark::State& state) {
  march(state, [] { return marched(sand(), 0.25, 0.1); });
}

BENCHMARK(mkz_marched)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(pm4sand_vertical)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(pm4sand_marched)->Arg(40)->Unit(benchmark::kMillisecond);

} // namespace
