// CPU time of LayeredField::sample against layers, points, samples and damping model, and of an equivalent
// linear analysis. `cost_wavefield --benchmark_out=cost.json --benchmark_out_format=json`, then plot_cost.py
// cost.json.

#include "wavefield/layers/equivalent_linear.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace {

using namespace tremolo::wavefield;

LayeredHalfSpace profile_of(std::int64_t layers, const Damping& damping) {
  const double ratio = damping.model == DampingModel::none ? 0.0 : 0.03;
  LayeredHalfSpace profile{.layers = {},
                           .half_space = {2200.0, 800.0, 1600.0},
                           .half_space_damping = 0.3 * ratio,
                           .damping = damping};
  for (std::int64_t j = 0; j < layers; ++j) {
    const double vs = 150.0 + 400.0 * static_cast<double>(j) / static_cast<double>(layers);
    profile.layers.push_back({.thickness = 40.0 / static_cast<double>(layers),
                              .density = 1900.0,
                              .vs = vs,
                              .vp = 2.0 * vs,
                              .damping = ratio});
  }
  return profile;
}

/// A record's length of shaking: sines under an envelope, nothing above 25 Hz.
Signal shaking(double duration) {
  const auto velocity = [=](double t) {
    if (t < 0.0 || t > duration) {
      return 0.0;
    }
    const double envelope = std::pow(std::sin(std::numbers::pi * t / duration), 4);
    return 0.1 * envelope * (std::sin(12.0 * t) + std::sin(31.0 * t + 1.0) + 0.5 * std::sin(77.0 * t + 2.0));
  };
  return {velocity, 0.0, duration, 25.0};
}

constexpr double dt = 0.005;
constexpr Quantities velocity_only{.displacement = false, .stress = false, .strain = false, .rates = false};
constexpr Quantities velocity_and_stress{.displacement = false, .strain = false, .rates = false};

void sample_all(benchmark::State& state, std::int64_t layers, std::int64_t points, std::int64_t samples,
                const Damping& damping, const Quantities& quantities) {
  const double duration = dt * static_cast<double>(samples);
  const LayeredField field(profile_of(layers, damping), {WaveType::SV, 0.26, 0.0, -50.0}, 0.0,
                           shaking(0.7 * duration));
  std::vector<Point> all;
  for (std::int64_t i = 0; i < points; ++i) {
    all.push_back({0.0, -50.0 * static_cast<double>(i) / static_cast<double>(points)});
  }
  const TimeGrid grid{0.0, dt, static_cast<std::size_t>(samples)};
  for (auto iteration : state) {
    benchmark::DoNotOptimize(field.sample(all, grid, Part::total, quantities));
  }
  state.counters["series"] = static_cast<double>(points) * (quantities.stress ? 5.0 : 2.0);
}

constexpr Damping undamped{};
constexpr Damping hysteretic{DampingModel::hysteretic, 0.0};
constexpr Damping kelvin_voigt{DampingModel::kelvin_voigt, 3.0};

void layers(benchmark::State& state) {
  sample_all(state, state.range(0), 100, 16384, undamped, velocity_only);
}
void layers_kelvin_voigt(benchmark::State& state) {
  sample_all(state, state.range(0), 100, 16384, kelvin_voigt, velocity_only);
}
void points(benchmark::State& state) {
  sample_all(state, 5, state.range(0), 16384, undamped, velocity_only);
}
void points_hysteretic(benchmark::State& state) {
  sample_all(state, 5, state.range(0), 16384, hysteretic, velocity_only);
}
void points_with_stress(benchmark::State& state) {
  sample_all(state, 5, state.range(0), 16384, undamped, velocity_and_stress);
}
void samples(benchmark::State& state) {
  sample_all(state, 5, 100, state.range(0), undamped, velocity_only);
}

void equivalent_linear_layers(benchmark::State& state) {
  const auto ground = profile_of(state.range(0), hysteretic);
  const StrainCurves curves{[](double strain) { return 1.0 / (1.0 + strain / 1e-3); },
                            [](double strain) { return 0.02 + 0.15 * strain / (1e-3 + strain); }};
  const std::vector<StrainCurves> all(ground.layers.size(), curves);
  std::vector<double> acceleration(8000);
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    acceleration[i] = 10.0 * shaking(40.0).velocity(dt * static_cast<double>(i));
  }
  std::size_t iterations = 0;
  for (auto iteration : state) {
    const auto result = equivalent_linear(ground, all, WaveType::SV, 0.26, {acceleration, dt});
    iterations = result.iterations.size();
    benchmark::DoNotOptimize(result);
  }
  state.counters["iterations"] = static_cast<double>(iterations);
}

BENCHMARK(layers)->RangeMultiplier(2)->Range(1, 64)->Unit(benchmark::kMillisecond);
BENCHMARK(layers_kelvin_voigt)->RangeMultiplier(2)->Range(1, 64)->Unit(benchmark::kMillisecond);
BENCHMARK(points)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(points_hysteretic)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(points_with_stress)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(samples)->RangeMultiplier(4)->Range(1024, 65536)->Unit(benchmark::kMillisecond);
BENCHMARK(equivalent_linear_layers)->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

} // namespace
