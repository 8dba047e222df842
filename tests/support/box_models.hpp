#pragma once

// Changes of an elastic box (box_run.hpp) into the models whose bits are compared.

#include "mpm_domain/spec/spec.hpp"

namespace tremolo::test_support {

/// Clay weak enough to yield in the wave.
inline void yield(mpm_domain::Spec& spec) {
  materials::MohrCoulomb clay;
  clay.elastic = materials::elasticity(spec.soils.front().law);
  clay.cohesion_peak = clay.cohesion_residual = 100.0;
  spec.soils.front().law = clay;
}

inline void add_layers(mpm_domain::Spec& spec) {
  using enum mpm_domain::Side;
  spec.matched_sides = {left, right, base};
}

/// Springs beside all dashpots around one centre.
/// @param lags  at the base
inline void add_springs(mpm_domain::Spec& spec, double across, double along, Vector centre,
                        bool lags = false) {
  using mpm_domain::Side;
  for (const Side side : {Side::left, Side::right, Side::base})
    spec.springs.push_back({side, across, along, centre, lags && side == Side::base});
}

/// @param below  what stands below the base
inline void make_periodic(mpm_domain::Spec& spec, const materials::Elasticity& below = {2600.0, 1e9, 0.2}) {
  spec.sides = mpm_domain::Sides::periodic;
  spec.below_base = below;
}

/// A corner of the box in cells of half the size, and part of it in cells of a quarter.
inline void refine_corner(mpm_domain::Spec& spec) {
  spec.refine = {{{0.0, -14.0, 30.0, 0.0}, 1}, {{0.0, -5.0, 12.0, 0.0}, 2}};
}

inline void put_into_container(mpm_domain::Spec& spec) {
  spec.sides = mpm_domain::Sides::container;
  spec.rigid_base = true;
}

/// Water in the lower half, where it flows or not.
inline void add_water(mpm_domain::Spec& spec, materials::Drainage drainage) {
  spec.gravity = 9.81;
  spec.water = {-20.0, {}};
  spec.soils.front().pores = {
      .porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-3, .drainage = drainage};
}

/// Water below a line that falls from a quarter of the depth to three quarters.
inline void add_sloping_water(mpm_domain::Spec& spec, materials::Drainage drainage) {
  add_water(spec, drainage);
  const double depth = spec.box.y_max - spec.box.y_min;
  spec.water->line = {{spec.box.x_min, spec.box.y_max - 0.25 * depth},
                      {spec.box.x_max, spec.box.y_max - 0.75 * depth}};
}

} // namespace tremolo::test_support
