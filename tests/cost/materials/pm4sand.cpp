// Time of one update of PM4Sand (D_R 55 %, 101.3 kPa, K_0 = 0.5) against the increment of shear strain, at
// constant volume: four cycles of 0.05 % amplitude (ten increments if that is more), and again. One point
// alone; and 100,000 points spread evenly over the test, so that at every step some reverse.

#include "materials/law/law.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tremolo::materials {
namespace {

Pm4Sand sand() {
  return pm4sand({.density = 1900.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4});
}

/// Shear strain up and down between plus and minus an amplitude, in equal increments.
class Triangle {
public:
  explicit Triangle(double increment)
      : increment_(increment), quarter_(std::max(std::lround(5e-4 / increment), 10L)) {}
  double increment(long step) const {
    return (step + quarter_) / (2 * quarter_) % 2 == 0 ? increment_ : -increment_;
  }
  long steps() const { return 16 * quarter_; } ///< of four cycles

private:
  double increment_;
  long quarter_;
};

/// Points and their arrays.
class Sample {
public:
  explicit Sample(std::size_t count)
      : size_(state_variables(law_).size()), stress_(4 * count), state_(count * size_), work_(count),
        strain_(4 * count),
        points_{
            count,     &stress_[0], &stress_[count], &stress_[2 * count], &stress_[3 * count], state_.data(),
            &work_[0], &strain_[0], &strain_[count], &strain_[2 * count], &strain_[3 * count]} {}

  /// Point 0 at the start of the test.
  void begin() {
    points_.sxx[0] = -50.65e3;
    points_.syy[0] = -101.3e3;
    points_.sxy[0] = 0.0;
    Points first = points_;
    first.count = 1;
    initialise(law_, first);
  }
  /// Makes point i a copy of a sample's first.
  void copy(std::size_t i, const Sample& from) {
    points_.sxx[i] = from.points_.sxx[0];
    points_.syy[i] = from.points_.syy[0];
    points_.szz[i] = from.points_.szz[0];
    points_.sxy[i] = from.points_.sxy[0];
    std::copy_n(from.state_.begin(), size_, state_.begin() + static_cast<std::ptrdiff_t>(i * size_));
  }
  void strain(std::size_t i, double shear) { strain_[2 * points_.count + i] = shear; }
  void step() { update(law_, points_); }
  std::size_t bytes_of_state() const { return size_ * sizeof(double); }

private:
  Law law_ = sand();
  std::size_t size_;
  std::vector<double> stress_;
  std::vector<double> state_;
  std::vector<double> work_;
  std::vector<double> strain_;
  Points points_;
};

void report(benchmark::State& run, std::size_t count, const Sample& sample) {
  run.counters["time_per_update"] =
      benchmark::Counter(static_cast<double>(count),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  run.counters["bytes_of_state"] = static_cast<double>(sample.bytes_of_state());
}

void alone(benchmark::State& run, double increment) {
  const Triangle path(increment);
  Sample sample(1);
  long step = path.steps();
  for (auto _ : run) {
    if (step == path.steps()) {
      sample.begin();
      step = 0;
    }
    sample.strain(0, path.increment(step++));
    sample.step();
    benchmark::ClobberMemory();
  }
  report(run, 1, sample);
}

void many(benchmark::State& run, double increment) {
  constexpr std::size_t count = 100000;
  const Triangle path(increment);
  Sample guide(1);
  Sample sample(count);
  std::vector<long> steps(count);
  guide.begin();
  long step = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (; step < static_cast<long>(i) * path.steps() / static_cast<long>(count); ++step) {
      guide.strain(0, path.increment(step));
      guide.step();
    }
    sample.copy(i, guide);
    steps[i] = step;
  }
  for (auto _ : run) {
    run.PauseTiming();
    for (std::size_t i = 0; i < count; ++i) {
      sample.strain(i, path.increment(steps[i]++));
    }
    run.ResumeTiming();
    sample.step();
    benchmark::ClobberMemory();
  }
  report(run, count, sample);
}

BENCHMARK_CAPTURE(alone, 1e_7, 1e-7);
BENCHMARK_CAPTURE(alone, 1e_6, 1e-6);
BENCHMARK_CAPTURE(alone, 1e_5, 1e-5);
BENCHMARK_CAPTURE(alone, 1e_4, 1e-4);
BENCHMARK_CAPTURE(alone, 1e_3, 1e-3);
BENCHMARK_CAPTURE(many, 1e_7, 1e-7)->Iterations(20);
BENCHMARK_CAPTURE(many, 1e_6, 1e-6)->Iterations(20);
BENCHMARK_CAPTURE(many, 1e_5, 1e-5)->Iterations(20);
BENCHMARK_CAPTURE(many, 1e_4, 1e-4)->Iterations(4);
BENCHMARK_CAPTURE(many, 1e_3, 1e-3)->Iterations(1);

} // namespace
} // namespace tremolo::materials
