#include "materials/soiltest/cyclic/calibrate.hpp"

#include "materials/law/parameter_check.hpp"
#include "materials/soiltest/path/root.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

void check(const StrengthTarget& target, const ParameterRange& range) {
  materials::check_range("stress_ratio", target.stress_ratio, least_stress_ratio, largest_stress_ratio);
  materials::check_positive("cycles", target.cycles);
  materials::check_positive("least parameter", range.least);
  materials::check_range("largest parameter", range.most, range.least, 1e300);
  materials::check_range("first guess of the parameter", range.guess, range.least, range.most);
}

} // namespace

Calibration calibrate(const LawOf& law, const SoilTest& test, const StrengthTarget& target,
                      const ParameterRange& range) {
  check(target, range);
  Calibration fit;
  const double most_cycles = 3.0 * target.cycles;
  const auto excess = [&](double log_parameter) {
    const FailureTest failure = cycles_to_failure(law(std::exp(log_parameter)), test, target.stress_ratio,
                                                  most_cycles, target.criterion);
    fit.updates += failure.updates;
    fit.cpu_seconds += failure.cpu_seconds;
    return std::log(failure.cycles / target.cycles);
  };
  const Root root =
      find_root(excess, {std::log(range.guess), std::log(range.least), std::log(range.most), 1.0, 5e-3});
  fit.parameter = std::exp(root.x);
  fit.cycles = target.cycles * std::exp(root.value);
  fit.tests = root.evaluations;
  if (!root.found) {
    throw std::runtime_error(fmt::format("no parameter from {:g} to {:g} reaches {} in {:g} cycles at the "
                                         "stress ratio {:g}; nearest: {:g} with {:g} "
                                         "cycles{}",
                                         range.least, range.most, name(target.criterion), target.cycles,
                                         target.stress_ratio, fit.parameter, fit.cycles,
                                         fit.cycles >= 0.999 * most_cycles ? " or more" : ""));
  }
  // The count may jump past the target, e.g. from a few cycles to never; cycles are counted in halves.
  if (!(std::abs(fit.cycles - target.cycles) <= std::max(1.0, 0.1 * target.cycles))) {
    throw std::runtime_error(
        fmt::format("the number of cycles to {} jumps past {:g} at the parameter {:g}, to {:g}: no "
                    "parameter gives it at the stress ratio {:g}",
                    name(target.criterion), target.cycles, fit.parameter, fit.cycles, target.stress_ratio));
  }
  SoilTest check = test;
  StressCycles loading;
  loading.stress_ratio = target.stress_ratio;
  check.loading = loading;
  const CyclicStrength strength = cyclic_strength(law(fit.parameter), check, target.cycles, target.criterion);
  fit.strength = strength.stress_ratio;
  fit.strength_error = strength.stress_ratio / target.stress_ratio - 1.0;
  fit.tests += strength.tests;
  fit.updates += strength.updates;
  fit.cpu_seconds += strength.cpu_seconds;
  return fit;
}

} // namespace tremolo::soiltest
