#pragma once

// Linings in sand under water up to its surface.

#include "tests/support/lined_ring.hpp"
#include "tests/support/liquefied_tunnel.hpp"

#include <vector>

namespace tremolo::test_support {

/// A circular lining with the mass of a cylinder.
/// @param density  of that, kg/m3
inline mpm_domain::Lining light_lining(const Vector& centre, double radius, double thickness, double density,
                                       double friction) {
  const double axis = radius - 0.5 * thickness;
  const double of_wall = density * radius * radius / (2.0 * axis * thickness);
  return {.name = "ring",
          .outline = circle(centre, radius),
          .thickness = thickness,
          .section = mpm_domain::plate_section(thickness, 30e9, 0.2, of_wall),
          .hinges = {},
          .friction = {friction},
          .adhesion = {0.0}};
}

/// The ring of lined_ring.hpp about a centre.
inline mpm_domain::Lining concrete_lining(const Vector& centre, double friction) {
  mpm_domain::Lining lining = ring_lining();
  for (Vector& corner : lining.outline)
    corner = {corner.x + centre.x, corner.y + centre.y};
  lining.friction = {friction};
  lining.adhesion = {0.0};
  return lining;
}

/// The mean velocity of a beam, m/s.
inline Vector mean_velocity(const mpm_domain::Beam& beam) {
  const auto sums = momenta(beam);
  return {sums[0] / beam.mass(), sums[1] / beam.mass()};
}

/// The middle of its mass, m.
inline Vector middle(const mpm_domain::Beam& beam) {
  Vector sum{};
  for (std::size_t k = 0; k < beam.node_count(); ++k) {
    const double share = beam.masses()[beam.first_dof(k)] / beam.mass();
    sum = {sum.x + share * beam.position(k).x, sum.y + share * beam.position(k).y};
  }
  return sum;
}

/// Sand that bears no tension, and nothing where it has liquefied, in a box that nothing leaves.
inline mpm_domain::Spec cohesionless_sand(double width, double depth, double h, materials::Drainage drainage,
                                          double young) {
  mpm_domain::Spec spec = saturated_flat_ground(width, depth, h, drainage, young);
  materials::MohrCoulomb sand;
  sand.elastic = {heavy_fluid::saturated, young, 0.3};
  sand.friction_peak = sand.friction_residual = 0.5;
  spec.soils.front().law = sand;
  spec.sides = mpm_domain::Sides::periodic;
  spec.below_base = materials::Elasticity{2600.0, 1e13, 0.2};
  return spec;
}

} // namespace tremolo::test_support
