// A crust of undrained soil that lies half above the water table, over sand whose water flows, shaken
// sideways and up and down. Nodes between both let no water pass. Where the remap of musl gave them the flow
// of the sand beside them, the sand pumped water into the crust that no force had moved.

#include "wet_scenes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tremolo {
namespace {

using namespace test_support;
using namespace mpm_domain;

constexpr double cell = 1.0; // m

Soil elastic(const char* name, double young, double permeability, materials::Drainage drainage) {
  Soil soil{.name = name};
  soil.pores = {.porosity = 0.4, .grain_density = 2650.0, .permeability = permeability, .drainage = drainage};
  soil.law = materials::LinearElastic{{materials::saturated_density(*soil.pores, {}), young, 0.3}};
  soil.damping_time = 1e-3;
  return soil;
}

/// A column of a fill, which may be absent, on 2 m of clay with the table at its middle, on 4 m of sand.
/// @param fill  its thickness, m
Spec crust(StepOrder order, double fill) {
  constexpr double depth = 6.0;
  Spec spec;
  spec.box = {0.0, -depth, cell, fill + cell};
  spec.cell_size = cell;
  spec.gravity = 9.81;
  spec.sides = Sides::periodic;
  spec.water = {-1.0, {}};
  spec.scheme.order = order;
  spec.scheme.fraction = 0.8;
  spec.soils = {elastic("sand", 100e6, 1e-4, materials::Drainage::coupled),
                elastic("clay", 80e6, 1e-8, materials::Drainage::undrained),
                {.name = "fill", .law = materials::LinearElastic{{1600.0, 80e6, 0.3}}, .damping_time = 1e-3}};
  const auto add = [&](std::size_t soil, double bottom, double top) {
    spec.regions.push_back({soil, {{0.0, bottom}, {cell, bottom}, {cell, top}, {0.0, top}}});
  };
  add(0, -depth, -2.0);
  add(1, -2.0, 0.0);
  if (fill > 0.0)
    add(2, 0.0, fill);
  return spec;
}

class HardCase40UndrainedCrust : public testing::TestWithParam<StepOrder> {};

TEST_P(HardCase40UndrainedCrust, MakesNoEnergy) {
  for (const double fill : {0.0, 2.0}) {
    const auto domain = at_rest(crust(GetParam(), fill));
    Stepper stepper(*domain, 0.0, [](long, double t, auto, auto field) {
      const double omega = 2.0 * std::numbers::pi;                            // 1 Hz
      const double v = 0.24 * (1.0 - std::cos(omega * t)) * std::min(1.0, t); // m/s
      std::ranges::fill(field, eq6::FreeField{{v, 0.1 * v}, {}});
    });
    double kinetic = 0.0;
    double pressure = 0.0;
    while (stepper.time() < 1.0) {
      stepper.step();
      kinetic = std::max(kinetic, domain->energy.kinetic);
      pressure = std::max(pressure, std::abs(largest_wet(*domain, excess_of)));
    }
    bounded(fmt::format("energy that nothing has given over the largest kinetic one, {} m of fill", fill),
            std::abs(domain->energy.residual()) / kinetic, 0.02);
    bounded(fmt::format("excess pressure over the weight of the ground, {} m of fill", fill),
            pressure / (1900.0 * 9.81 * (6.0 + fill)), 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, HardCase40UndrainedCrust, testing::Values(StepOrder::musl, StepOrder::usl),
                         [](const auto& order) { return std::string(tremolo::name(order.param)); });

} // namespace
} // namespace tremolo
