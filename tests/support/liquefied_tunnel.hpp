#pragma once

// A tunnel, 5 m across, held fast in liquefied soil, a heavy fluid of grains and water without effective
// stress: the contact forces of a step that begins at rest.

#include "mpm_domain/contact/contact_nodes.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/structure_scene.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::test_support {

/// The sand of spec sheets for a tunnel 5 m wide.
namespace heavy_fluid {
inline constexpr double gravity = 9.81; // m/s2
inline constexpr double porosity = 0.437;
inline constexpr double grains = 2650.0; // kg/m3
inline constexpr double water = 1000.0;  // kg/m3
inline constexpr double saturated = (1.0 - porosity) * grains + porosity * water;
} // namespace heavy_fluid

/// Flat ground of that sand, under water up to its surface.
inline mpm_domain::Spec saturated_flat_ground(double width, double depth, double h,
                                              materials::Drainage drainage, double young) {
  mpm_domain::Spec spec = flat_ground(width, depth, h, {heavy_fluid::saturated, young, 0.3});
  spec.water = mpm_domain::GroundWater{0.0, {.density = heavy_fluid::water}};
  spec.soils.front().pores = materials::PoreSpace{.porosity = heavy_fluid::porosity,
                                                  .grain_density = heavy_fluid::grains,
                                                  .permeability = 1e-4,
                                                  .drainage = drainage};
  return spec;
}

/// Sums over the nodes of a tunnel, N/m.
struct TunnelForces {
  static constexpr double diameter = 5.0;  // m
  static constexpr double density = 300.0; // kg/m3
  static constexpr double area = 0.25 * std::numbers::pi * diameter * diameter;
  static constexpr double weight = density * area * heavy_fluid::gravity;
  static constexpr double of_fluid = heavy_fluid::saturated * area * heavy_fluid::gravity;

  double at_rest = 0.0; ///< lift of water at rest
  double lift = 0.0;    ///< of the excess pressure
  double aside = 0.0;   ///< likewise, along x
  double pressed = 0.0; ///< sum of the normal forces' sizes
  double rubbed = 0.0;  ///< of the tangential ones
  double along = 0.0;   ///< of what pushes the soil along the surface

  double total_lift() const { return at_rest + lift; }
};

/// What holds soil that has just liquefied and a structure that is held fast, over the step from rest.
/// @param dt  s
inline std::vector<mpm_domain::ContactPoint> first_contact(mpm_domain::Domain& domain, double dt) {
  using namespace mpm_domain;
  liquefy(domain);
  scatter(domain, ScatterPart::both);
  for (std::size_t n = 0; n < domain.grid.size(); ++n)
    if (domain.grid.mass[n] > empty_mass(domain)) {
      domain.grid.vx_after[n] = dt * domain.grid.force_x[n] / domain.grid.mass[n];
      domain.grid.vy_after[n] = dt * domain.grid.force_y[n] / domain.grid.mass[n];
    }
  const RigidBody& body = domain.contact.bodies().front();
  ContactNodes contact;
  contact.follow_sort(domain, body.surface(), 4.0);
  contact.find(domain, body.surface(), body.centre(), domain.spec.structures.front(), nullptr);
  contact.take_trial(domain, dt);
  std::vector<ContactPoint> points(contact.nodes().begin(), contact.nodes().end());
  solve_contact(1e30, 1e30, {}, points);
  return points;
}

/// @param offset  of the axis from a node, m
inline TunnelForces tunnel_forces(mpm_domain::Spec spec, double offset) {
  using namespace mpm_domain;
  constexpr double dt = 1e-5;
  spec.structures = {
      structure(circle({offset, -5.5 - offset}, 0.5 * TunnelForces::diameter), TunnelForces::density, 0.4)};
  Domain domain(spec);
  const std::vector<ContactPoint> points = first_contact(domain, dt);
  const RigidBody& body = domain.contact.bodies().front();
  TunnelForces forces;
  const Head head(0.0);
  const WaterAround water{head, heavy_fluid::water * heavy_fluid::gravity};
  forces.at_rest = body.load(heavy_fluid::gravity, water).force.y + TunnelForces::weight;
  for (const ContactPoint& p : points) {
    forces.lift += p.normal_impulse / dt * p.normal.y;
    forces.aside += p.normal_impulse / dt * p.normal.x;
    forces.pressed += p.normal_impulse / dt;
    forces.rubbed += std::abs(p.tangential_impulse) / dt;
    forces.along += std::abs(p.tangential * p.slip_speed) / dt;
  }
  return forces;
}

} // namespace tremolo::test_support
