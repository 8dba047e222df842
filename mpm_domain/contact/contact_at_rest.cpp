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
  refuse_elastic_corners();
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
    unbalanced += elastic_[b] ? relax_elastic(grid, b, gain) : relax_rigid(b, keep, gain);
    for (const ContactNode& c : nodes(b)) {
      grid.vx_after[c.node] += c.solid_change.x;
      grid.vy_after[c.node] += c.solid_change.y;
    }
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const ContactNode& c : nodes(b)) {
      if (left_out[c.node] ||
          std::ranges::any_of(std::span(nodes_).first(b),
                              [&](const ContactNodes& earlier) { return earlier.has(c.node); }))
        continue; // counted already
      const double inertia = c.mass / gain;
      unbalanced += square({grid.force_x[c.node] + inertia * (grid.vx_after[c.node] - c.solid_trial.x),
                            grid.force_y[c.node] + inertia * (grid.vy_after[c.node] - c.solid_trial.y)});
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
  return inertia * inertia *
         (square({u.velocity.x - keep * last.velocity.x, u.velocity.y - keep * last.velocity.y}) +
          radius2 * turn * turn);
}

double Contact::relax_elastic(Grid& grid, std::size_t body, double gain) const {
  double unbalanced = 0.0;
  for (const ContactNode& c : nodes(body)) {
    const std::size_t n = c.body_node;
    const double inertia = c.body_mass / gain;
    grid.vx_after[n] += c.body_change.x;
    grid.vy_after[n] += c.body_change.y;
    unbalanced +=
        square({grid.force_x[n] + inertia * c.body_change.x, grid.force_y[n] + inertia * c.body_change.y});
  }
  return unbalanced;
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
