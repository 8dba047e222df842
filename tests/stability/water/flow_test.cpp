// Water at rest and in slow flow: permeabilities nine orders of magnitude apart, jumps of porosity, surfaces
// between cells, free water, consolidation to its end.

#include "mpm_domain/clocks/clock_nodes.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/water/water_scatter.hpp"
#include "wet_scenes.hpp"

#include <gtest/gtest.h>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double gravity = 9.81;

Soil wet_soil(const char* name, double porosity, double permeability, double young = 20e6) {
  Soil soil{.name = name};
  soil.pores = {.porosity = porosity, .grain_density = 2650.0, .permeability = permeability};
  soil.law = materials::LinearElastic{{materials::saturated_density(*soil.pores, {}), young, 0.25}};
  return soil;
}

Region band(std::size_t soil, double left, double right, double bottom, double top) {
  return {soil, {{left, bottom}, {right, bottom}, {right, top}, {left, top}}};
}

Spec wet_spec(Box box, double cell, double level) {
  Spec spec;
  spec.box = box;
  spec.cell_size = cell;
  spec.gravity = gravity;
  spec.water = {level, {}};
  return spec;
}

/// Layers of 1e-1 to 1e-9 m/s, all under the same excess pressure at the start.
TEST(HardCase20Permeabilities, PermeabilitiesNineOrdersApart) {
  constexpr double load = 1e4; // Pa
  Spec spec = wet_spec({0.0, -10.0, 0.5, 0.0}, 0.5, 0.0);
  spec.sides = Sides::periodic;
  spec.scheme.fraction = 0.95; // no limit but that of h/c_1
  std::size_t layer = 0;
  for (const double k : {1e-1, 1e-3, 1e-5, 1e-7, 1e-9}) {
    spec.soils.push_back(wet_soil("layer", 0.4, k));
    const double top = -2.0 * static_cast<double>(layer);
    spec.regions.push_back(band(layer++, 0.0, 0.5, top - 2.0, top));
  }
  const auto domain = at_rest(spec);
  for (Particles& set : domain->sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
      set.pore_pressure[k] += load;
      set.syy[k] += load;
    }
  Stepper stepper(*domain, 0.0, quiet_ground());
  double fastest = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
  while (stepper.time() < 3.0) {
    stepper.step();
    fastest = std::max(fastest, largest_wet(*domain, flux));
    highest = std::max(highest, largest_wet(*domain, excess_of));
    lowest = std::max(lowest, largest_wet(*domain, [](const Particles& p, std::size_t k) {
                        return -excess_pressure(p, k);
                      }));
  }
  // The steepest gradient there can be: the load over half a cell, in the most permeable layer.
  bounded("flux over k i", fastest / (1e-1 * load / (1000.0 * gravity * 0.25)), 1.05);
  // Where drag is weak the release rings: it overshoots by at most what was released.
  bounded("highest pressure over the load", highest / load, 2.0);
  bounded("suction over the load", lowest / load, 1.0);
  bounded("energy", ledger_error(domain->energy), 0.02);
}

/// Free water over a stepped slope, dry ground above the table, porosity 0.35 against 0.5 and permeability
/// 1e-2 against 1e-6 m/s, no surface on a row of nodes.
Spec stepped_ground() {
  Spec spec = wet_spec({0.0, -6.0, 12.0, 2.0}, 0.5, -0.9);
  spec.soils = {wet_soil("dense", 0.35, 1e-2), wet_soil("loose", 0.5, 1e-6)};
  spec.regions = {{0, {{0.0, -6.0}, {12.0, -6.0}, {12.0, 1.3}, {6.0, 1.3}, {0.0, -2.3}}},
                  {1, {{3.0, -5.2}, {9.0, -4.4}, {9.0, -2.1}, {3.0, -3.2}}}};
  return spec;
}

TEST(HardCase21WaterAtRest, RestOverJumpsOfPorosityAndPermeability) {
  const auto domain = at_rest(stepped_ground());
  Stepper stepper(*domain, 0.0, quiet_ground());
  double fastest = 0.0;
  double flow = 0.0;
  while (stepper.time() < 1.0) {
    stepper.step();
    fastest = std::max(fastest, largest_wet(*domain, speed));
    flow = std::max(flow, largest_wet(*domain, flux));
  }
  bounded("largest speed", fastest, 1e-6, "m/s");
  bounded("largest flux", flow, 1e-9, "m/s");
  bounded("drift of pressure over that of the depth",
          largest_wet(*domain, excess_of) / (1000.0 * gravity * 6.0), 1e-3);
}

/// Level ground that has moved to the right by this share of a cell, within its sides, under a pressure that
/// carries nearly its weight.
double unevenness_of_pressure(double share, double* energy_error) {
  constexpr double cell = 0.5;
  Spec spec = wet_spec({0.0, -4.0, 8.0, 0.0}, cell, 0.0);
  spec.soils = {wet_soil("sand", 0.4, 1e-3, 2e6)};
  spec.regions = {band(0, 0.0, 8.0, -4.0, 0.0)};
  const auto domain = at_rest(spec);
  for (Particles& set : domain->sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
      set.x[k] += share * cell;
      const double depth = (0.5 - std::floor(set.y[k] / cell) - 1.0) * cell;
      const double liquefied = 0.8 * materials::buoyant_density(set.water->pores, {}) * gravity * depth;
      set.pore_pressure[k] += liquefied;
      set.sxx[k] += liquefied;
      set.syy[k] += liquefied;
      set.szz[k] += liquefied;
    }
  Stepper stepper(*domain, 0.0, quiet_ground());
  while (stepper.time() < 1.0)
    stepper.step();
  // At mid-depth, over the mean.
  double lowest = std::numeric_limits<double>::infinity();
  double highest = 0.0;
  for (const Particles& set : domain->sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
      if (set.y[k] < -2.0 && set.y[k] > -2.5) {
        lowest = std::min(lowest, excess_pressure(set, k));
        highest = std::max(highest, excess_pressure(set, k));
      }
  *energy_error = ledger_error(domain->energy);
  return 2.0 * (highest - lowest) / (highest + lowest);
}

/// Sides let no water pass wherever their soil ends within a cell.
void expect_no_flow(std::initializer_list<double> shares) {
  for (const double share : shares) {
    double energy = 0.0;
    bounded("pressure along the ground over its mean", unevenness_of_pressure(share, &energy), 0.01);
    bounded("energy", energy, 0.02);
  }
}

TEST(HardCase21WaterAtRest, SidesWithinCellsHoldWater) {
  expect_no_flow({0.25});
}

TEST(HardCase21WaterAtRest, AcceptanceSidesWithinCellsHoldWater) {
  expect_no_flow({0.0, 0.5, 0.75});
}

/// The force on water per unit of soil volume, sum V n p grad S, would drive it at jumps of porosity. The
/// force of a pressure n p is taken here, less the weight n rho_f g, over the mass of the water.
TEST(HardCase21WaterAtRest, ForcesPerVolumeOfSoilDriveWaterAtRest) {
  Spec spec = wet_spec({0.0, -6.0, 3.0, 0.0}, 0.5, 0.0);
  spec.soils = {wet_soil("dense", 0.35, 1e-2), wet_soil("loose", 0.5, 1e-6)};
  spec.regions = {band(0, 0.0, 3.0, -6.0, 0.0), band(1, 0.0, 3.0, -4.0, -2.0)};
  Domain domain(spec);
  const ClockNodes nodes(domain);
  const auto residual = [&](bool per_soil) {
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
        const double rest = rest_pressure(set, k);
        set.pore_pressure[k] = rest + (per_soil ? set.water->pores.porosity : 1.0) * rest; // its excess
      }
    scatter_mixture(domain, nodes.of(0), nodes.ties_of(0));
    double largest = 0.0; // acceleration over g inside
    const Grid& grid = domain.grid;
    for (int j = 0; j < grid.ny; ++j)
      for (int i = 0; i < grid.nx; ++i) {
        const double y = grid.y0 + j * grid.h;
        const double x = grid.x0 + i * grid.h;
        const std::size_t n = grid.index(i, j);
        if (y < -5.6 || y > -0.4 || x < 0.4 || x > 2.6)
          continue;
        const double mass = per_soil ? grid.water_mass[n] : 1000.0 * grid.wet_volume[n];
        largest = std::max(largest, std::abs(grid.water_force_y[n] / (mass * gravity) - 1.0));
      }
    return largest;
  };
  bounded("acceleration of water at rest, per unit of its volume", residual(false), 1e-10, "g");
  breaks("acceleration, per unit of soil", residual(true), 1.0, "g");
}

/// The excess pressure of soil that had liquefied leaves within minutes of flow. What water leaves is what
/// the ground settles.
/// @param permeability  m/s
/// @param end           s
void expect_consolidation(double permeability, double end) {
  Spec spec = wet_spec({0.0, -5.0, 0.5, 0.0}, 0.5, 0.0);
  spec.sides = Sides::periodic;
  spec.water->fluid.bulk_modulus = 2e7; // some ten times the skeleton: the step is ten times as long
  spec.soils = {wet_soil("sand", 0.4, permeability, 2e6)};
  spec.regions = {band(0, 0.0, 0.5, -5.0, 0.0)};
  spec.scheme.fraction = 0.9;
  const auto domain = at_rest(spec);
  for (Particles& set : domain->sets)
    for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k) {
      // A pressure is that of its cell: what differs within one does not flow.
      const double depth = (0.5 - std::floor(set.y[k] / 0.5) - 1.0) * 0.5;
      const double liquefied = 0.95 * materials::buoyant_density(set.water->pores, {}) * gravity * depth;
      set.pore_pressure[k] += liquefied;
      set.syy[k] += liquefied;
    }
  Stepper stepper(*domain, 0.0, quiet_ground());
  const auto volume_of_pores = [&] {
    double volume = 0.0;
    for (const Particles& set : domain->sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
        volume += set.volume[k] - set.water->grains_per_mass * set.mass[k];
    return volume;
  };
  // The edges of the ground: particles keep half their height from them.
  const auto top = [&] {
    return largest_wet(*domain, [](const Particles& p, std::size_t k) { return p.y[k] + p.volume[k] / 0.5; });
  };
  const auto bottom = [&] {
    return -largest_wet(*domain,
                        [](const Particles& p, std::size_t k) { return p.volume[k] / 0.5 - p.y[k]; });
  };
  const double pores = volume_of_pores();
  const double thickness = top() - bottom();
  const double start = largest_wet(*domain, excess_of);
  double before = 1.0;
  double rise = 0.0;
  for (double look = 20.0; look <= end; look += 20.0) {
    while (stepper.time() < look)
      stepper.step();
    const double ratio = largest_wet(*domain, excess_of) / start;
    rise = std::max(rise, ratio - before);
    before = ratio;
  }
  const double settlement = thickness - (top() - bottom());
  bounded("excess pressure left over that at the start", before, 2e-3);
  bounded("rise of pressure on the way", rise, 1e-6);
  bounded("settlement against the water that left",
          std::abs(settlement / ((pores - volume_of_pores()) / 0.5) - 1.0), 5e-3);
  // Nothing but dashpots holds the base. The bound is hard case 14's, 1e-4 m in a minute.
  bounded("sinking of the base", std::abs(-5.0 - bottom()), 1e-3, "m");
  bounded("energy", ledger_error(domain->energy), 0.02);
}

TEST(HardCase27Reconsolidation, ConsolidationAfterShaking) {
  expect_consolidation(4e-3, 100.0);
}

TEST(HardCase27Reconsolidation, AcceptanceTenMinutesOfConsolidation) {
  expect_consolidation(1e-3, 600.0);
}

} // namespace
} // namespace tremolo
