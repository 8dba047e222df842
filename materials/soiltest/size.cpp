#include "materials/soiltest/size.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string_view>

namespace tremolo::soiltest {
namespace {

double count(const Monotonic& loading, double increment) {
  return loading.strain / increment;
}

double count(const StressCycles& loading, double increment) {
  return 4.0 * loading.largest_strain * loading.most_cycles / increment;
}

/// A quarter cycle there, one back, and loops of four amplitudes in between.
double count(const StrainCycles& loading, double increment) {
  const double sum = std::accumulate(loading.amplitudes.begin(), loading.amplitudes.end(), 0.0);
  return sum * (2.0 + 4.0 * loading.cycles) / increment;
}

double count(const Path& path, double /*increment*/) {
  return path.rows.empty() ? 0.0 : path.rows.back().step - path.rows.front().step;
}

std::string_view remedy(const Loading& loading) {
  if (std::holds_alternative<StressCycles>(loading))
    return "a larger strain_increment, fewer most_cycles or a smaller largest_strain";
  return std::holds_alternative<StrainCycles>(loading) ? "a larger strain_increment or fewer cycles"
         : std::holds_alternative<Path>(loading)       ? "fewer increments in the column step"
                                                       : "a larger strain_increment or a smaller strain";
}

} // namespace

double increments(const SoilTest& test) {
  return std::visit([&](const auto& loading) { return count(loading, test.strain_increment); }, test.loading);
}

void check_size(const SoilTest& test) {
  const double steps = increments(test);
  if (!(steps <= most_increments)) {
    throw std::invalid_argument(fmt::format("the test takes up to {:.3g} increments, at most {:g} are run: "
                                            "give it {}",
                                            steps, most_increments, remedy(test.loading)));
  }
  const double rows = steps / static_cast<double>(test.every);
  if (!(rows <= most_rows)) {
    throw std::invalid_argument(fmt::format("the test keeps up to {:.3g} rows of its history, at most {:g} "
                                            "fit: every = {} must be at least {:.0f}, or give it {}",
                                            rows, most_rows, test.every, std::ceil(steps / most_rows),
                                            remedy(test.loading)));
  }
}

} // namespace tremolo::soiltest
