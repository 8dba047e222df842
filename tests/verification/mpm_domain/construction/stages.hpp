#pragma once

// Models that are built up and dug out in construction stages.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "tests/support/box_run.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain::test {

constexpr double gravity = 9.81;
constexpr double density = 20e3 / gravity; // gamma = 20 kN/m3
constexpr double modulus = 20e6;           // M, Pa
constexpr double poisson = 0.25;           // E = M (1 + nu)(1 - 2 nu)/(1 - nu) = M/1.2

inline Region layer(double width, double bottom, double top, std::size_t soil = 0) {
  return {soil, {{0.0, bottom}, {width, bottom}, {width, top}, {0.0, top}}};
}

/// Level ground of this soil from y = -depth to `top`, between periodic sides.
inline Spec level_ground(double width, double depth, double top, double h) {
  Spec spec = test_support::elastic_box(width, depth, h);
  spec.box.y_max = top;
  spec.soils.front().law = materials::LinearElastic{{density, modulus / 1.2, poisson}};
  spec.gravity = gravity;
  spec.sides = Sides::periodic;
  spec.regions = {layer(width, -depth, top)};
  return spec;
}

/// A construction stage before which the model had these regions and structures.
inline StaticStage construction(std::vector<Region> before, double residual, double ramp = 2.0,
                                bool undrained = false, std::vector<Structure> structures = {},
                                std::optional<GroundWater> water = {}) {
  return ConstructionSettings{
      {.ramp = ramp, .residual = residual, .max_time = 60.0, .undrained = {undrained}},
      std::move(before),
      std::move(structures),
      water};
}

inline Reactions rest(Domain& domain, std::span<const StaticStage> stages, double residual) {
  return bring_to_rest(domain, {.residual = residual}, stages, [](std::size_t, long, double) {});
}

} // namespace tremolo::mpm_domain::test
