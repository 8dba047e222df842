// What accuracy costs with PM4Sand (D_R 55 %, direct simple shear at constant volume, 101.3 kPa, K_0 = 0.5):
// the strain increment and, of the sub-steps, the largest strain, the least strain and the tolerance, each an
// axis of its own, against the error in cycles to 3 % strain at a stress ratio of 0.147, in stress along
// cycles of 0.1 % and 1 % strain, and against the time of those. Errors are those to increments of 1e-6 in
// sub-steps of 1e-7 at a tolerance of 1e-7. CSV on standard output; pm4sand_accuracy.py draws it.

#include "materials/law/driver.hpp"
#include "tests/support/cyclic_shear.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <initializer_list>
#include <vector>

using namespace tremolo::materials;

namespace {

constexpr double vertical = -101.3e3; // Pa
constexpr PointStress initial = {0.5 * vertical, vertical, 0.5 * vertical, 0.0};

Pm4Sand sand(const Pm4Integration& integration) {
  Pm4Sand law = pm4sand({.density = 1900.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4});
  law.integration = integration;
  return law;
}

double cycles_to_three_per_cent(const Pm4Sand& law, double increment) {
  PointTest point(law, initial);
  tremolo::testing::CyclicShear shear(point, -0.147 * vertical, 0.0, increment);
  constexpr double many = 200.0; // where sub-steps are taken whatever their error, some never get there
  while (std::abs(point.strain().xy) < 0.03 && shear.cycle() < many) {
    shear.step();
  }
  return shear.cycle();
}

/// Stresses every 0.1 % along six cycles of 0.1 % strain and two of 1 %, and the time of the path.
struct StrainCycles {
  std::vector<PointStress> marks;
  double microseconds = 0.0;
};

StrainCycles strain_cycles(const Pm4Sand& law, double increment) {
  constexpr double mark = 1e-3;
  const long steps = std::lround(mark / increment);
  StrainCycles result;
  int repeats = 0;
  const std::clock_t begin = std::clock();
  std::clock_t end = begin;
  do {
    PointTest point(law, initial);
    result.marks.clear();
    const auto go = [&](double direction, int marks) {
      for (int i = 0; i < marks; ++i) {
        for (long k = 0; k < steps; ++k) {
          point.apply({Control::strain(0.0), Control::strain(0.0), Control::strain(direction * increment)});
        }
        result.marks.push_back(point.stress());
      }
    };
    for (int cycle = 0; cycle < 6; ++cycle) {
      go(1.0, 1);
      go(-1.0, 2);
      go(1.0, 1);
    }
    for (int cycle = 0; cycle < 2; ++cycle) {
      go(1.0, 10);
      go(-1.0, 20);
      go(1.0, 10);
    }
    ++repeats;
    end = std::clock();
  } while (end - begin < CLOCKS_PER_SEC / 5);
  result.microseconds = 1e6 * static_cast<double>(end - begin) / CLOCKS_PER_SEC / repeats;
  return result;
}

/// Largest difference of a stress component over the initial vertical stress.
double difference(const StrainCycles& a, const StrainCycles& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.marks.size(); ++i) {
    largest = std::max({largest, std::abs(a.marks[i].xx - b.marks[i].xx),
                        std::abs(a.marks[i].yy - b.marks[i].yy), std::abs(a.marks[i].xy - b.marks[i].xy)});
  }
  return largest / -vertical;
}

} // namespace

int main() {
  const Pm4Sand exact = sand({.largest_strain = 1e-7, .tolerance = 1e-7, .smallest_strain = 1e-9});
  const double cycles = cycles_to_three_per_cent(exact, 1e-6);
  const StrainCycles path = strain_cycles(exact, 1e-6);
  std::printf(
      "increment,largest_strain,smallest_strain,tolerance,cycles,cycles_error,stress_error,microseconds\n");
  const auto print = [&](const Pm4Integration& by, double increment) {
    const Pm4Sand law = sand(by);
    const double found = cycles_to_three_per_cent(law, increment);
    const StrainCycles ours = strain_cycles(law, increment);
    std::printf("%g,%g,%g,%g,%.4f,%.2e,%.2e,%.1f\n", increment, by.largest_strain, by.smallest_strain,
                by.tolerance, found, std::abs(found - cycles), difference(ours, path), ours.microseconds);
    std::fflush(stdout);
  };
  const Pm4Integration usual;
  for (const double increment : {1e-6, 1e-5, 1e-4, 1e-3}) {
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
      print({usual.largest_strain, tolerance, usual.smallest_strain}, increment);
    for (const double largest : {1e-5, 1e-4, 1e-3, 1e-2})
      for (const double smallest : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4})
        if (smallest <= largest)
          print({largest, usual.tolerance, smallest}, increment);
  }
}
