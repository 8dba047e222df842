// What accuracy costs with PDMY03: the increment of shear strain against the error in cycles to 3 % strain
// (direct simple shear at constant volume, 101 kPa, K_0 = 0.5), in stress after cycles of 0.1 % strain, and
// against the time of a cycle. Errors are those to increments of 2e-7. CSV on standard output:
// relative_density,increment,cycles,cycles_error,stress_error,microseconds_per_cycle; pdmy03_accuracy.py
// draws it.

#include "materials/law/driver.hpp"
#include "tests/support/cyclic_shear.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <initializer_list>

using namespace tremolo::materials;

namespace {

constexpr double vertical = -101e3; // Pa
constexpr PointStress initial = {0.5 * vertical, vertical, 0.5 * vertical, 0.0};

double cycles_to_three_per_cent(const Pdmy03& law, double stress_ratio, double increment) {
  PointTest point(law, initial);
  tremolo::testing::CyclicShear shear(point, -stress_ratio * vertical, 0.0, increment);
  while (std::abs(point.strain().xy) < 0.03) {
    shear.step();
  }
  return shear.cycle();
}

constexpr int cycles = 4;
constexpr double amplitude = 1e-3;

/// Stresses at the turning points of strain cycles, and their time.
struct StrainCycles {
  std::array<PointStress, 2 * cycles> turns;
  double microseconds = 0.0; ///< of one cycle
};

StrainCycles strain_cycles(const Pdmy03& law, double increment) {
  const auto quarter = static_cast<long>(std::lround(amplitude / increment));
  StrainCycles result;
  int repeats = 0;
  const std::clock_t begin = std::clock();
  std::clock_t end = begin;
  do {
    PointTest point(law, initial);
    double direction = 1.0;
    for (std::size_t turn = 0; turn < result.turns.size(); ++turn) {
      for (long k = 0; k < (turn == 0 ? quarter : 2 * quarter); ++k) {
        point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(direction * increment)});
      }
      direction = -direction;
      result.turns[turn] = point.stress();
    }
    ++repeats;
    end = std::clock();
  } while (end - begin < CLOCKS_PER_SEC / 10);
  result.microseconds = 1e6 * static_cast<double>(end - begin) / CLOCKS_PER_SEC / (repeats * (cycles - 0.25));
  return result;
}

double largest_difference(const StrainCycles& a, const StrainCycles& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.turns.size(); ++k) {
    largest =
        std::max({largest, std::abs(a.turns[k].xy - b.turns[k].xy), std::abs(a.turns[k].yy - b.turns[k].yy)});
  }
  return largest;
}

} // namespace

int main() {
  std::printf("relative_density,increment,cycles,cycles_error,stress_error,microseconds_per_cycle\n");
  constexpr double exact = 2e-7;
  for (const auto& [density, stress_ratio] :
       {std::pair(0.33, 0.09), std::pair(0.57, 0.16), std::pair(0.74, 0.29)}) {
    const Pdmy03 law = pdmy03({.relative_density = density});
    const double cycles_exact = cycles_to_three_per_cent(law, stress_ratio, exact);
    const StrainCycles stress_exact = strain_cycles(law, exact);
    for (const double increment : {1e-6, 2e-6, 5e-6, 1e-5, 2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3}) {
      const double count = cycles_to_three_per_cent(law, stress_ratio, increment);
      const StrainCycles stress = strain_cycles(law, increment);
      std::printf("%.2f,%g,%.4f,%.4f,%.6f,%.2f\n", density, increment, count, count - cycles_exact,
                  largest_difference(stress, stress_exact) / -vertical, stress.microseconds);
    }
  }
}
