// Sand that liquefies, dilates until its water cavitates, or lies under a dry crust; and a load that is
// suddenly there.

#include "materials/sand/pm4sand/pm4sand.hpp"
#include "tests/support/growing_load.hpp"
#include "wet_scenes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double height = 10.0; // m
constexpr double cell = 0.5;    // m
constexpr double gravity = 9.81;
constexpr double frequency = 1.0; // Hz

struct Sand {
  double relative_density, G_o, h_po;
};
constexpr Sand loose{0.35, 476.0, 0.53};
constexpr Sand dense{0.75, 890.0, 0.63};

/// @param level   of the water table, m
/// @param lowest  pressure that the water bears, Pa
Spec sand_column(const Sand& sand, double level, double lowest) {
  const double void_ratio = 0.8 - 0.3 * sand.relative_density;
  Spec spec;
  spec.box = {0.0, -height, cell, 0.0};
  spec.cell_size = cell;
  spec.gravity = gravity;
  spec.sides = Sides::periodic;
  spec.water = {level, {.cavitation_pressure = lowest}};
  Soil soil{.name = "sand"};
  soil.pores = {
      .porosity = materials::porosity_of(void_ratio), .grain_density = 2650.0, .permeability = 1e-4};
  auto law = materials::pm4sand({.density = materials::saturated_density(*soil.pores, {}),
                                 .relative_density = sand.relative_density,
                                 .G_o = sand.G_o,
                                 .h_po = sand.h_po});
  law.elastic.at_rest = 0.5;
  soil.law = law;
  soil.damping_time = 0.005 / (std::numbers::pi * 5.0);
  spec.soils = {soil};
  spec.regions = {{0, {{0.0, -height}, {cell, -height}, {cell, 0.0}, {0.0, 0.0}}}};
  return spec;
}

/// On a rigid base that moves with this acceleration (m/s2).
FreeFieldSource shaken_base(Domain& domain, double acceleration) {
  for (BoundaryFace& face : domain.boundary.faces()) {
    face.ground.impedance_p *= 1e3;
    face.ground.impedance_s *= 1e3;
  }
  return [acceleration](long, double t, auto, auto field) {
    const double omega = 2.0 * std::numbers::pi * frequency;
    const double v = acceleration / omega * (1.0 - std::cos(omega * t)) * std::min(1.0, t);
    std::ranges::fill(field, eq6::FreeField{{v, 0.0}, {}});
  };
}

double ratio(const Particles& set, std::size_t k) {
  return excess_pressure(set, k) / -set.vertical_at_rest[k];
}

void expect_full_liquefaction(double end) {
  constexpr double acceleration = 0.2 * gravity;
  const auto domain = at_rest(sand_column(loose, 0.0, -90e3));
  Stepper stepper(*domain, 0.0, shaken_base(*domain, acceleration));
  double fastest = 0.0;
  double highest = 0.0;
  while (stepper.time() < end) {
    stepper.step();
    if (stepper.steps() % 16 != 0)
      continue;
    fastest = std::max(fastest, largest_wet(*domain, speed));
    highest =
        std::max(highest, largest_wet(*domain, [](const Particles& p, std::size_t k) { return p.y[k]; }));
  }
  reaches("largest r_u", largest_wet(*domain, ratio), 0.9);
  bounded("largest speed", fastest, 3.0 * acceleration / (std::numbers::pi * frequency) + 1.0, "m/s");
  bounded("highest particle over the surface", highest, 2.0 * cell, "m");
  bounded("energy", ledger_error(domain->energy), 0.02);
}

TEST(HardCase24FullLiquefaction, FullLiquefaction) {
  expect_full_liquefaction(5.0);
}

TEST(HardCase24FullLiquefaction, AcceptanceFifteenSecondsOfShaking) {
  expect_full_liquefaction(15.0);
}

void expect_cavitation(double end) {
  constexpr double lowest = -2e3; // Pa: little tension, so that it is reached
  const auto domain = at_rest(sand_column(dense, 0.0, lowest));
  Stepper stepper(*domain, 0.0, shaken_base(*domain, 0.4 * gravity));
  double below = 0.0;    // what p* would have been
  double pressure = 0.0; // that acts
  while (stepper.time() < end) {
    stepper.step();
    below = std::max(
        below, largest_wet(*domain, [](const Particles& p, std::size_t k) { return -p.pore_pressure[k]; }));
    pressure = std::max(pressure, largest_wet(*domain, [](const Particles& p, std::size_t k) {
                          return -p.water->pressure(p.pore_pressure[k]);
                        }));
  }
  reaches("tension that water does not bear over that which it does", below / -lowest, 1.0);
  exactly("largest tension of the water", pressure, -lowest, "Pa");
  bounded("energy", ledger_error(domain->energy), 0.02);
}

TEST(HardCase25Cavitation, DilationUntilWaterCavitates) {
  expect_cavitation(2.0);
}

TEST(HardCase25Cavitation, AcceptanceEightSecondsOfShaking) {
  expect_cavitation(8.0);
}

void expect_dry_crust(double end) {
  constexpr double acceleration = 0.2 * gravity;
  const auto domain = at_rest(sand_column(loose, -2.2, -90e3)); // the table within a cell
  Stepper stepper(*domain, 0.0, shaken_base(*domain, acceleration));
  double fastest = 0.0;
  while (stepper.time() < end) {
    stepper.step();
    fastest = std::max(fastest, largest_wet(*domain, speed));
  }
  for (const Particles& set : domain->sets)
    if (!set.water) {
      EXPECT_GT(set.size(), 0U);
      EXPECT_TRUE(set.pore_pressure.empty() && set.wx.empty()) << "dry soil has water";
    }
  reaches("largest r_u", largest_wet(*domain, ratio), 0.8);
  bounded("largest speed", fastest, 3.0 * acceleration / (std::numbers::pi * frequency) + 1.0, "m/s");
  bounded("energy", ledger_error(domain->energy), 0.02);
}

TEST(HardCase26DryCrust, DryCrustOverLiquefiedSand) {
  expect_dry_crust(5.0);
}

TEST(HardCase26DryCrust, AcceptanceTenSecondsOfShaking) {
  expect_dry_crust(10.0);
}

/// 100 kPa on 10 m of saturated elastic soil within half its period: it swings about the undrained
/// share of the water, by as much as it was loaded.
TEST(HardCase22UndrainedStepLoad, UndrainedStepLoad) {
  constexpr double modulus = 1e8; // M, Pa
  constexpr double load = 1e5;    // Pa
  constexpr double rise =
      12e-3; // s, of 4 H/c_u = 24 ms: higher modes, which dispersion puts out of step, stay small
  Spec spec;
  spec.box = {0.0, -height, cell, cell};
  spec.cell_size = cell;
  spec.gravity = gravity;
  spec.sides = Sides::periodic;
  spec.water = {0.0, {}};
  Soil soil{.name = "sand"};
  soil.pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-5};
  soil.law = materials::LinearElastic{{materials::saturated_density(*soil.pores, {}), modulus, 0.0}};
  constexpr double at_first = 10.0; // of the load, Pa
  spec.soils = {
      soil, {.name = "load", .law = materials::LinearElastic{{at_first / (gravity * cell), modulus, 0.0}}}};
  spec.regions = {{0, {{0.0, -height}, {cell, -height}, {cell, 0.0}, {0.0, 0.0}}},
                  {1, {{0.0, 0.0}, {cell, 0.0}, {cell, cell}, {0.0, cell}}}};
  const auto domain = at_rest(spec);
  for (BoundaryFace& face : domain->boundary.faces()) {
    face.ground.impedance_p *= 1e3;
    face.ground.impedance_s *= 1e3;
  }
  Particles& layer = *std::ranges::find_if(
      domain->sets, [](const Particles& set) { return set.soil == "load" && set.size() > 0; });
  Stepper stepper(*domain, 0.0, quiet_ground());
  const double share = 1.0 / (1.0 + modulus * 0.4 / 2.2e9);
  double highest = 0.0;
  double lowest = 0.0;
  double sum = 0.0;
  double count = 0.0;
  while (stepper.time() < 1.0) {
    layer.weight_share = 1.0 + load / at_first * smooth_step(stepper.time() / rise); // its mass stays
    stepper.step();
    highest = std::max(highest, largest_wet(*domain, excess_of));
    lowest = std::max(lowest, largest_wet(*domain, [](const Particles& p, std::size_t k) {
                        return -excess_pressure(p, k);
                      }));
    for (const Particles& set : domain->sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
        if (set.y[k] < -0.5 * height) {
          sum += excess_pressure(set, k);
          count += 1.0;
        }
  }
  bounded("highest pressure over the undrained share of the load", highest / (share * load), 2.05);
  bounded("suction over the load", lowest / load, 0.05);
  bounded("mean in the lower half against the undrained share", std::abs(sum / count / (share * load) - 1.0),
          0.02);
}

} // namespace
} // namespace tremolo
