#include "materials/soiltest/cyclic/cyclic_strength.hpp"

#include "materials/law/parameter_check.hpp"
#include "materials/soiltest/path/root.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

const StressCycles& stress_cycles(const SoilTest& test) {
  const auto* loading = std::get_if<StressCycles>(&test.loading);
  if (loading == nullptr)
    throw std::invalid_argument("cyclic strength needs a test with cycles by stress ratio");
  return *loading;
}

/// Cycles that end where the criterion is met.
StressCycles until(Criterion criterion, double stress_ratio, double most_cycles) {
  StressCycles loading;
  loading.stress_ratio = stress_ratio;
  loading.most_cycles = most_cycles;
  switch (criterion) {
  case Criterion::strain_1pc:
    loading.largest_strain = 0.01;
    break;
  case Criterion::strain_3pc:
    loading.largest_strain = 0.03;
    break;
  case Criterion::strain_5pc:
    loading.largest_strain = 0.05;
    break;
  case Criterion::double_amplitude_5pc:
    loading.largest_strain = 0.1;
    break;
  case Criterion::ru_98:
    loading.largest_strain = 0.2;
    loading.pore_pressure_ratio = 0.98;
  }
  return loading;
}

} // namespace

double cycles(const CyclesTo& reached, Criterion criterion) {
  switch (criterion) {
  case Criterion::strain_1pc:
    return reached.strain_1pc;
  case Criterion::strain_3pc:
    return reached.strain_3pc;
  case Criterion::strain_5pc:
    return reached.strain_5pc;
  case Criterion::double_amplitude_5pc:
    return reached.double_amplitude_5pc;
  default:
    return reached.ru_98;
  }
}

FailureTest cycles_to_failure(const materials::Law& law, const SoilTest& test, double stress_ratio,
                              double most_cycles, Criterion criterion) {
  SoilTest one = test;
  one.loading = until(criterion, stress_ratio, most_cycles);
  one.every = std::numeric_limits<std::size_t>::max(); // no history but the reversals
  const Result result = run(law, one);
  FailureTest failure = {cycles(result.cycles_to, criterion), result.updates, result.cpu_seconds};
  if (std::isnan(failure.cycles)) {
    if (result.end != End::most_cycles) {
      throw std::runtime_error(fmt::format("at the stress ratio {:g} the soil does not reach {}: {}",
                                           stress_ratio, name(criterion), result.end_reason));
    }
    failure.cycles = most_cycles;
  }
  return failure;
}

CyclicStrength cyclic_strength(const materials::Law& law, const SoilTest& test, double cycles,
                               Criterion criterion) {
  const double guess = stress_cycles(test).stress_ratio;
  materials::check_positive("cycles", cycles);
  CyclicStrength strength;
  const auto excess = [&](double log_ratio) {
    const FailureTest failure = cycles_to_failure(law, test, std::exp(log_ratio), 3.0 * cycles, criterion);
    strength.updates += failure.updates;
    strength.cpu_seconds += failure.cpu_seconds;
    return std::log(failure.cycles / cycles);
  };
  constexpr double usual_slope = -1.0 / sand_exponent;
  const Root root = find_root(excess, {std::log(guess), std::log(least_stress_ratio),
                                       std::log(largest_stress_ratio), usual_slope, 1e-3});
  strength.tests = root.evaluations;
  strength.stress_ratio = std::exp(root.x);
  strength.cycles = cycles * std::exp(root.value);
  if (!root.found) {
    throw std::runtime_error(fmt::format("no stress ratio from {:g} to {:g} reaches {} in {:g} cycles; the "
                                         "nearest is {:g} with {:g} cycles{}",
                                         least_stress_ratio, largest_stress_ratio, name(criterion), cycles,
                                         strength.stress_ratio, strength.cycles,
                                         strength.cycles >= 2.99 * cycles ? " or more" : ""));
  }
  return strength;
}

double blow_count(double relative_density) {
  materials::check_range("relative_density", relative_density, 0.0, 1.0);
  return 46.0 * relative_density * relative_density;
}

double idriss_boulanger_strength(double n) {
  materials::check_range("(N1)60cs", n, 0.0, 46.0);
  return std::exp(n / 14.1 + std::pow(n / 126.0, 2) - std::pow(n / 23.6, 3) + std::pow(n / 25.4, 4) - 2.8);
}

double idriss_boulanger_strength(double blow_count, double cycles) {
  materials::check_positive("cycles", cycles);
  return idriss_boulanger_strength(blow_count) * std::pow(15.0 / cycles, sand_exponent);
}

} // namespace tremolo::soiltest
