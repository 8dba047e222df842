// Soil that is removed, or a load that comes, while pore water cannot flow. In one dimension water takes
//
//     dp/q = -Q/(M + Q),      Q = K_f/n,
//
// of what is removed, and the grains the rest. In a drained stage after it the excess is gone.

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "tests/verification/mpm_domain/construction/stages.hpp"

#include <gtest/gtest.h>

namespace tremolo::mpm_domain::test {
namespace {

constexpr double height = 10.0;
constexpr double width = 1.0;
constexpr double removed = 2.0; // m of dry soil
constexpr double porosity = 0.4;
constexpr double residual = 1e-9;

Spec wet_ground() {
  Spec spec = level_ground(width, height, removed, 0.5);
  spec.water = {0.0, {.density = 1000.0, .bulk_modulus = 2.0e8}};
  spec.soils.front().pores = {.porosity = porosity,
                              .grain_density = 2650.0,
                              .permeability = 1e-3,
                              .drainage = materials::Drainage::coupled};
  spec.soils.push_back(spec.soils.front());
  spec.soils.back().name = "fill";
  spec.soils.back().pores.reset();
  return spec;
}

std::vector<Region> with_fill() {
  return {layer(width, -height, 0.0), layer(width, 0.0, removed, 1)};
}

TEST(Undrained, UnloadingIsThatOfTheWater) {
  for (const auto drainage : {materials::Drainage::coupled, materials::Drainage::undrained}) {
    Spec spec = wet_ground();
    spec.soils.front().pores->drainage = drainage;
    spec.regions = {layer(width, -height, 0.0)};
    Domain domain(spec);
    const StaticStage dig = construction(with_fill(), residual, 2.0, true, {}, spec.water);
    rest(domain, {&dig, 1}, residual);
    const double q = density * gravity * removed;
    const double water = 2.0e8 / porosity;
    for (const Particles& p : domain.sets)
      for (std::size_t k = 0; p.traits.wet && k < p.size(); ++k) {
        const double excess = excess_pressure(p, k);
        EXPECT_NEAR(excess / q, -water / (modulus + water), 1e-3) << "y = " << p.y[k];
        const double effective = p.weight_share * p.density * gravity * p.y[k]; // as before but for M/(M+Q)
        EXPECT_NEAR(p.syy[k], effective - q + q * modulus / (modulus + water), 0.5e-3 * q);
      }
  }
}

TEST(Undrained, ExcessPressureIsGoneAfterADrainedStage) {
  Spec spec = wet_ground();
  spec.regions = with_fill();
  Domain domain(spec);
  const std::vector<StaticStage> stages{
      construction(with_fill(), residual, 2.0, true, {}, spec.water),
      construction({layer(width, -height, 0.0)}, residual, 2.0, false, {}, spec.water)};
  rest(domain, stages, residual);
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; p.traits.wet && k < p.size(); ++k) {
      EXPECT_NEAR(p.pore_pressure[k], rest_pressure(p, k), 1e-6);
      EXPECT_NEAR(p.y[k], p.y_initial[k], 1e-6); // the ground has come back
    }
}

// Clay below drained sand: each takes the weight of a fill by itself, up to the cell where they meet.
TEST(Undrained, ClayAloneHoldsItsWaterWhereAStageSaysSo) {
  Spec spec = wet_ground();
  spec.soils.push_back(spec.soils.front());
  spec.soils.back().name = "clay";
  std::vector<Region> ground{layer(width, -height, -5.0, 2), layer(width, -5.0, 0.0)};
  spec.regions = ground;
  spec.regions.push_back(layer(width, 0.0, removed, 1));
  std::vector<StaticStage> stages{construction(ground, residual, 2.0, true, {}, spec.water)};
  std::get<ConstructionSettings>(stages.front()).undrained.names = {"clay"};
  const double q = density * gravity * removed;
  const double share = 2.0e8 / porosity / (modulus + 2.0e8 / porosity);
  Domain domain(spec);
  rest(domain, stages, residual);
  for (const Particles& p : domain.sets)
    for (std::size_t k = 0; p.traits.wet && k < p.size(); ++k) {
      const double of_water = p.soil == "clay" ? share : 0.0;
      EXPECT_NEAR(excess_pressure(p, k) / q, of_water, 1e-3) << p.soil << ", y = " << p.y[k];
      const double before = p.weight_share * p.density * gravity * p.y[k];
      EXPECT_NEAR((before - p.syy[k]) / q, 1.0 - of_water, 1e-3) << p.soil << ", y = " << p.y[k];
    }
  stages.push_back(construction(spec.regions, residual, 2.0, false, {}, spec.water));
  Domain drained(spec);
  rest(drained, stages, residual);
  for (const Particles& p : drained.sets)
    for (std::size_t k = 0; p.traits.wet && k < p.size(); ++k)
      EXPECT_NEAR(excess_pressure(p, k) / q, 0.0, 1e-9);
}

} // namespace
} // namespace tremolo::mpm_domain::test
