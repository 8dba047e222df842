// A permeability that is scaled up lets liquefied ground settle sooner: what that saves and what it changes.
// Prints
//
//     factor, time, settlement, pressure, cpu
//
// for a column of 5 m whose sand has liquefied: factor on the permeability, time times that factor (s),
// settlement (m), mean excess pressure over that at the start, CPU time of the whole run (s).

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/quiet_ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

namespace tremolo::cost {
namespace {

using namespace mpm_domain;

constexpr double gravity = 9.81;      // m/s2
constexpr double cell = 0.5;          // m
constexpr double depth = 5.0;         // m
constexpr double permeability = 1e-4; // m/s
constexpr double end = 4000.0;        // s

Spec column(double factor) {
  Spec spec;
  spec.box = {0.0, -depth, cell, 0.0};
  spec.cell_size = cell;
  spec.gravity = gravity;
  spec.sides = Sides::periodic;
  spec.water = {0.0, {}};
  spec.water->fluid.bulk_modulus = 2e7; // some ten times the skeleton: the step is ten times as long
  Soil soil{.name = "sand"};
  soil.pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = factor * permeability};
  soil.law = materials::LinearElastic{{materials::saturated_density(*soil.pores, {}), 2e6, 0.25}};
  spec.soils = {soil};
  spec.regions = {{0, {{0.0, -depth}, {cell, -depth}, {cell, 0.0}, {0.0, 0.0}}}};
  spec.scheme.fraction = 0.9;
  return spec;
}

/// Excess pressure that carries 95 % of the sand above.
void liquefy(Domain& domain) {
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
      const double centre = (std::floor(set.y[k] / cell) + 0.5) * cell;
      const double excess = -0.95 * materials::buoyant_density(set.water->pores, {}) * gravity * centre;
      set.pore_pressure[k] += excess;
      set.syy[k] += excess;
    }
}

double mean_excess(const Domain& domain) {
  double sum = 0.0;
  double volume = 0.0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
      sum += set.volume[k] * excess_pressure(set, k);
      volume += set.volume[k];
    }
  return sum / volume;
}

/// By what the ground has lost of its volume, m.
double settlement(const Domain& domain) {
  double volume = 0.0;
  for (const Particles& set : domain.sets)
    for (const double v : set.volume)
      volume += v;
  return depth - volume / cell;
}

void settle(double factor) {
  const std::clock_t begin = std::clock();
  Domain domain(column(factor));
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  liquefy(domain);
  const double before = mean_excess(domain);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  struct Row {
    double time, settlement, pressure;
  };
  std::vector<Row> rows;
  for (double time = 100.0; time <= end; time += 100.0) {
    while (factor * stepper.time() < time)
      stepper.step();
    rows.push_back({time, settlement(domain), mean_excess(domain) / before});
  }
  const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  for (const Row& row : rows)
    fmt::print("{},{},{:.6g},{:.6g},{:.3g}\n", factor, row.time, row.settlement, row.pressure, cpu);
}

} // namespace
} // namespace tremolo::cost

int main() {
  fmt::print("factor,time,settlement,pressure,cpu\n");
  for (const double factor : {1.0, 10.0, 100.0, 1000.0})
    tremolo::cost::settle(factor);
}
