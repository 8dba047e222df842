// Contact in the gravity stage.

#include "mpm_domain/contact/contact.hpp"
#include "mpm_domain/ground.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::mpm_domain {

void Contact::begin_rest(Ground& ground) {
  constexpr double touching = 1e-6; // cells
  find_nodes(ground, true);
  corners_ = find_corners(bodies_, structures_, touching * ground.finest_lattice().h);
}

double Contact::relax(Ground& ground, double keep, double gain, bool bonded,
                      std::span<const unsigned char> left_out) {
  Grid& grid = ground.grid;
  for (ContactNodes& nodes : nodes_) {
    if (!bonded)
      nodes.end_bonds(ground.spec.gaps, ground.finest_lattice().h);
    nodes.take_relaxing(ground, gain);
  }
  solve(trial_motions(keep, gain), gain, bonded);
  double unbalanced = 0.0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!elastic_[b])
      unbalanced += relax_rigid(b, keep, gain);
    for (const ContactNode& c : nodes(b)) {
      grid.vx_after[c.node] += c.solid_change.x;
      grid.vy_after[c.node] += c.solid_change.y;
      if (c.body_mass > 0.0) {
        grid.vx_after[c.body_node] += c.body_change.x;
        grid.vy_after[c.body_node] += c.body_change.y;
      }
    }
  }
  return unbalanced + relax_nodes(grid, gain, left_out);
}

double Contact::relax_nodes(const Grid& grid, double gain, std::span<const unsigned char> left_out) const {
  double unbalanced = 0.0;
  for (std::size_t k = 0; k < uses_.size(); ++k) {
    const NodeUse& use = uses_[k];
    if (k > 0 && uses_[k - 1].node == use.node)
      continue; // counted already
    const ContactNode& c = node_of(use);
    const bool of_soil = !use.own && !c.key.against;
    if (of_soil && left_out[use.node])
      continue;
    const double inertia = (use.own ? c.body_mass : c.mass) / gain;
    const Vector change = grid.velocity_after(use.node) - (use.own ? c.body_trial : c.solid_trial);
    unbalanced += square(Vector{grid.force_x[use.node], grid.force_y[use.node]} + inertia * change);
  }
  return unbalanced;
}

double Contact::relax_rigid(std::size_t body, double keep, double gain) {
  RigidBody& b = bodies_[body];
  const RigidMotion last = b.motion();
  const RigidMotion& u = motions_[body];
  b.set_motion(u);
  const double inertia = b.mass() / gain;
  const double radius2 = b.inertia() / b.mass();
  const double turn = u.spin - keep * last.spin;
  return inertia * inertia * (square(u.velocity - keep * last.velocity) + radius2 * turn * turn);
}

void Contact::end_rest() {
  for (RigidBody& body : bodies_)
    body.set_motion({});
}

void Contact::displace(std::size_t body, const Vector& way, double turn) {
  RigidBody& b = bodies_[body];
  b.set_state({b.centre().x + way.x, b.centre().y + way.y, b.tilt() + turn, 0.0, 0.0, 0.0});
}

double Contact::speed(const Ground& ground, std::size_t body) const {
  if (!elastic_[body])
    return std::sqrt(2.0 * bodies_[body].kinetic_energy() / bodies_[body].mass());
  const Lattice& own = ground.bodies[elastic_[body]->number()].lattice;
  double mass = 0.0;
  double twice_energy = 0.0;
  for (std::size_t n = own.first; n < own.first + own.count(); ++n) {
    mass += ground.grid.mass[n];
    twice_energy += ground.grid.mass[n] * square(ground.grid.velocity_after(n));
  }
  return std::sqrt(twice_energy / mass);
}

} // namespace tremolo::mpm_domain
