// What working on a record of 2000 or 80 000 samples costs.

#include "motion/make/synthesis.hpp"
#include "motion/measures.hpp"
#include "motion/mend/process.hpp"
#include "motion/read/read.hpp"
#include "motion/read/write.hpp"
#include "motion/spectra.hpp"

#include <benchmark/benchmark.h>

#include <sstream>

namespace tremolo::motion {
namespace {

constexpr double dt = 0.005;

std::vector<double> noise(const benchmark::State& state) {
  return white_noise(1, static_cast<std::size_t>(state.range(0)));
}

void read_peer_text(benchmark::State& state) {
  const std::string text = peer_text({.unit = Unit::g, .dt = dt, .samples = noise(state)}, {});
  for (auto step : state) {
    std::istringstream stream(text);
    benchmark::DoNotOptimize(parse_record(stream, "x.AT2"));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size()) *
                          static_cast<std::int64_t>(state.iterations()));
}

void all_measures(benchmark::State& state) {
  const auto a = noise(state);
  for (auto step : state)
    benchmark::DoNotOptimize(measures(a, dt));
}

void response_200_periods(benchmark::State& state) {
  const auto a = noise(state);
  const auto periods = spaced_periods(0.01, 10.0, 200);
  for (auto step : state)
    benchmark::DoNotOptimize(response_spectrum(a, dt, periods, 0.05));
}

void resample_to_half_the_step(benchmark::State& state) {
  const auto a = noise(state);
  for (auto step : state)
    benchmark::DoNotOptimize(resampled(a, dt, 0.5 * dt));
}

void band_pass(benchmark::State& state) {
  const auto a = noise(state);
  for (auto step : state)
    benchmark::DoNotOptimize(band_passed(a, dt, {.low = 0.1, .high = 25.0, .order = 4}));
}

BENCHMARK(read_peer_text)->Arg(2000)->Arg(80000)->Unit(benchmark::kMillisecond);
BENCHMARK(all_measures)->Arg(2000)->Arg(80000)->Unit(benchmark::kMillisecond);
BENCHMARK(response_200_periods)->Arg(2000)->Arg(80000)->Unit(benchmark::kMillisecond);
BENCHMARK(resample_to_half_the_step)->Arg(2000)->Arg(80000)->Unit(benchmark::kMillisecond);
BENCHMARK(band_pass)->Arg(2000)->Arg(80000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace tremolo::motion
