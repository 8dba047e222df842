#include "mpm_domain/contact/contact.hpp"

#include "mesh/polygon_measures.hpp"
#include "mpm_domain/ground.hpp"
#include "mpm_domain/transfer/out_of_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

void add(RigidLoad& to, const Vector& force, const Vector& arm) {
  to.force += force;
  to.moment += cross(arm, force);
}

Vector mean(const Vector& a, const Vector& b) {
  return 0.5 * (a + b);
}

RigidMotion mean(const RigidMotion& a, const RigidMotion& b) {
  return {mean(a.velocity, b.velocity), 0.5 * (a.spin + b.spin)};
}

ContactWork sum(const ContactWork& a, const ContactWork& b) {
  return {a.kinetic + b.kinetic, a.gravity + b.gravity,   a.load + b.load,
          a.drag + b.drag,       a.friction + b.friction, a.impact + b.impact};
}

/// Gives water its change of motion. Drag has been booked on the mean of w before contact.
ContactWork add_to_water(Grid& grid, const ContactNode& c, double density, double dt) {
  const std::size_t n = c.node;
  const Vector before{grid.wx_after[n], grid.wy_after[n]};
  const Vector water = before + c.water_change;
  grid.wx_after[n] = water.x;
  grid.wy_after[n] = water.y;
  const double push = dt * c.water_mass / (density * grid.wet_volume[n]);
  const Vector drag{push * grid.water_force_x[n] - c.water_mass * (c.water_trial.x - c.water_before.x),
                    push * grid.water_force_y[n] - c.water_mass * (c.water_trial.y - c.water_before.y)};
  return {.kinetic = 0.5 * c.water_mass * (square(water) - square(before)),
          .drag = 0.5 * dot(drag, c.water_change - c.solid_change)};
}

/// Gives a node its change of motion; water that does not move by itself goes along.
ContactWork push(Ground& ground, std::size_t n, double mass, const Vector& change, bool with_water,
                 double dt) {
  Grid& grid = ground.grid;
  const Vector before = grid.velocity_after(n);
  const Vector after = before + change;
  grid.vx_after[n] = after.x;
  grid.vy_after[n] = after.y;
  grid.ax[n] += change.x / dt;
  grid.ay[n] += change.y / dt;
  if (with_water) {
    grid.wx_after[n] = after.x;
    grid.wy_after[n] = after.y;
  }
  return {.kinetic = 0.5 * mass * (square(after) - square(before)),
          .gravity = -0.5 * dt * ground.spec.gravity * mass * change.y};
}

/// Area within the outline of a structure, m2.
double area(const Structure& structure) {
  return std::abs(0.5 * mesh::signed_double_area(structure.outline));
}

std::optional<WaterAround> water_around(const Ground& ground) {
  if (!ground.head)
    return std::nullopt;
  return WaterAround{*ground.head, ground.spec.water->fluid.density * ground.spec.gravity};
}

} // namespace

Contact::Contact(const Spec& spec)
    : structures_(spec.structures), bodies_(structures_.begin(), structures_.end()), elastic_(bodies_.size()),
      nodes_(bodies_.size()), shared_(bodies_.size()), motions_(bodies_.size()), responses_(bodies_.size()),
      structure_loads_(spec), loads_(bodies_.size()), of_props_(bodies_.size()) {}

double Contact::kinetic_energy() const {
  double energy = 0.0;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (!elastic_[b])
      energy += bodies_[b].kinetic_energy();
  return energy;
}

double Contact::fastest_point() const {
  double speed2 = 0.0;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const Vector& point : surface(b).points())
      speed2 = std::max(speed2, square(bodies_[b].motion().at(bodies_[b].arm(point))));
  return std::sqrt(speed2);
}

BodyForces Contact::forces(std::size_t body) const {
  BodyForces forces;
  forces.weight = load(body);
  if (dt_ == 0.0)
    return forces;
  const auto add_all = [&](const ContactNode& c, double sense, const Vector& arm) {
    add(forces.normal, sense * c.effective_impulse / dt_ * c.normal, arm);
    add(forces.water, sense * (c.normal_impulse - c.effective_impulse) / dt_ * c.normal, arm);
    add(forces.friction, sense * c.tangential_impulse / dt_ * c.tangent(), arm);
  };
  for (const ContactNode& c : nodes(body))
    add_all(c, 1.0, c.arm);
  for_contacts_against(body, [&](std::size_t other, const ContactNode& c) {
    add_all(c, -1.0, bodies_[body].arm(bodies_[other].centre() + c.arm));
  });
  return forces;
}

template <class See>
void Contact::for_contacts_against(std::size_t structure, const See& see) const {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const ContactNode& c : nodes(b))
      if (c.key.against == structure)
        see(b, c);
}

void Contact::add_forces_of(std::size_t body, double dt, std::span<Vector> nodes,
                            std::span<RigidLoad> bodies) const {
  for (const ContactNode& c : this->nodes(body))
    nodes[c.node] = nodes[c.node] + c.mass / dt * c.solid_change;
  for_contacts_against(body, [&](std::size_t other, const ContactNode& c) {
    if (elastic_[other])
      nodes[c.body_node] = nodes[c.body_node] + c.body_mass / dt * c.body_change;
    else
      add(bodies[other], 1.0 / dt * (c.normal_impulse * c.normal + c.tangential_impulse * c.tangent()),
          c.arm);
  });
  for (const CornerContact& c : corners_)
    if (c.a == body)
      add(bodies[c.b], 1.0 / dt * c.impulse(), c.arm_b);
    else if (c.b == body)
      add(bodies[c.a], -1.0 / dt * c.impulse(), c.arm_a);
}

RigidLoad Contact::load(std::size_t body) const {
  return loads_[body] + of_props_[body];
}

Vector Contact::pull(std::size_t body) const {
  const double mass = elastic_[body] ? elastic_[body]->mass() : bodies_[body].mass();
  return structure_loads_.on(body) / mass;
}

void Contact::take_bodies(const Ground& ground) {
  std::size_t number = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (structures_[b].stiffness) {
      elastic_[b].emplace(structures_[b], number, ground.sets_of_body(number), ground.finest_lattice().h);
      ++number;
    }
  std::vector<std::vector<OtherStructure>> others(bodies_.size());
  for (std::size_t a = 0; a < bodies_.size(); ++a)
    for (std::size_t b = a + 1; b < bodies_.size(); ++b) {
      if (!elastic_[a] && !elastic_[b])
        continue;
      const bool first_is_met = !elastic_[b] || (elastic_[a] && area(structures_[a]) <= area(structures_[b]));
      const std::size_t met = first_is_met ? a : b;
      others[first_is_met ? b : a].push_back(
          {met, elastic_[met]->number(),
           std::min(structures_[a].friction_between, structures_[b].friction_between)});
    }
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    nodes_[b].meet_others(std::move(others[b])); // the loops found them in the order of their numbers
}

std::size_t Contact::structure_of(std::size_t elastic) const {
  const auto found = std::ranges::find_if(
      elastic_, [&](const std::optional<ElasticBody>& body) { return body && body->number() == elastic; });
  return static_cast<std::size_t>(found - elastic_.begin());
}

void Contact::follow_particles(const Ground& ground) {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (elastic_[b])
      elastic_[b]->follow(ground.sets_of_body(elastic_[b]->number()), bodies_[b]);
}

void Contact::follow_sort(const Ground& ground) {
  follow_particles(ground);
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    nodes_[b].follow_sort(ground, surface(b), ground.reach_of_structures());
    refuse_beyond_grid(ground, b);
    if (ground.mesh)
      refuse_coarse_cells(ground, b);
  }
}

void Contact::refuse_beyond_grid(const Ground& ground, std::size_t body) const {
  const Grid& grid = ground.grid;
  const mesh::Rectangle box = surface(body).bounds();
  if (box.x_max < grid.x0 || box.x_min > grid.x0 + (grid.nx - 1) * grid.h || box.y_max < grid.y0)
    throw OutOfReach(
        fmt::format("structure '{}' has left the model: its centre is at x = {:.6g} m, y = {:.6g} "
                    "m; a model that reaches farther holds it",
                    bodies_[body].name(), bodies_[body].centre().x, bodies_[body].centre().y));
}

void Contact::refuse_coarse_cells(const Ground& ground, std::size_t body) const {
  const int finest = ground.soil_lattice_count() - 1;
  for (const NearParticle& near : nodes_[body].near()) {
    const Particles& p = ground.sets[near.set];
    const Vector position{p.x[near.index], p.y[near.index]};
    if (surface(body).nearest(position).distance > ground.finest_lattice().h)
      continue;
    const GradedMesh::Touched touched = ground.mesh->touched(box_of(p, near.index));
    if (touched.coarsest < finest || touched.quarter)
      throw OutOfReach(fmt::format(
          "structure '{}' has come within a cell of soil on cells larger than the finest, at x = {:.6g} m, "
          "y = {:.6g} m, and meets soil on the finest alone: refine the mesh as far as it goes",
          bodies_[body].name(), position.x, position.y));
  }
}

void Contact::weigh(const Ground& ground, std::size_t body, double share, const RigidLoad& before) {
  RigidLoad whole = bodies_[body].load(ground.spec.gravity, water_around(ground));
  whole.force += structure_loads_.on(body);
  const auto blend = [share](double from, double to) { return from + share * (to - from); };
  loads_[body] = {{blend(before.force.x, whole.force.x), blend(before.force.y, whole.force.y)},
                  blend(before.moment, whole.moment)};
}

void Contact::find_nodes(Ground& ground, bool bonded) {
  std::vector<const BodySurface*> surfaces;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    surfaces.push_back(&surface(b));
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    nodes_[b].find(ground, surface(b), bodies_[b].centre(), structures_[b],
                   elastic_[b] ? &ground.bodies[elastic_[b]->number()] : nullptr, bonded, surfaces);
    weigh(ground, b, 1.0);
  }
  find_shared();
}

ContactWork Contact::meet(Ground& ground, double dt) {
  const double h = ground.finest_lattice().h;
  find_nodes(ground, false);
  for (ContactNodes& nodes : nodes_)
    nodes.take_trial(ground, dt);
  corners_ = find_corners(bodies_, structures_, 0.5 * h);
  solve(trial_motions(1.0, dt), dt, false);
  dt_ = dt;

  ContactWork work = add_changes(ground, dt);
  std::vector<RigidMotion> middle; // of the bodies, in the middle of the step
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    middle.push_back(mean(bodies_[b].motion(), motions_[b]));
    work = sum(work, book_body(ground.grid, b, middle[b], dt));
    if (!elastic_[b])
      bodies_[b].set_motion(motions_[b]);
  }
  for (const CornerContact& c : corners_) {
    const Vector a = middle[c.a].at(c.arm_a);
    const Vector b = middle[c.b].at(c.arm_b);
    const Vector slip = b - a;
    work.impact -= dot(c.impulse(), slip);
    work.friction -= c.tangential_impulse * dot({-c.normal.y, c.normal.x}, slip);
  }
  work.impact -= work.friction;
  return work;
}

/// Work of impulses, weight and loads on a body; for an elastic body the grid has already booked the last
/// two.
ContactWork Contact::book_body(const Grid& grid, std::size_t body, const RigidMotion& middle,
                               double dt) const {
  ContactWork work;
  if (!elastic_[body]) {
    work.load = dt * dot(structure_loads_.on(body), middle.velocity);
    work.gravity =
        dt * (dot(loads_[body].force, middle.velocity) + loads_[body].moment * middle.spin) - work.load;
  }
  for (const ContactNode& c : nodes(body)) {
    const Vector speed =
        elastic_[body] ? mean(c.body_before, grid.velocity_after(c.body_node)) : middle.at(c.arm);
    const Vector on_body{c.normal_impulse * c.normal.x + c.tangential_impulse * c.tangent().x,
                         c.normal_impulse * c.normal.y + c.tangential_impulse * c.tangent().y};
    work.impact -= dot(on_body, speed);
    if (c.rubs())
      work.friction -= c.tangential_impulse * dot(c.tangent(), speed);
  }
  return work;
}

/// Gives the nodes their changes of motion; what they dissipate, the bodies' share aside, stands as impact.
ContactWork Contact::add_changes(Ground& ground, double dt) {
  ContactWork work;
  Grid& grid = ground.grid;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const ContactNode& c : nodes(b)) {
      const bool flows = c.water_mass > 0.0;
      const bool with_water = ground.has_flow() && !flows;
      work = sum(work, push(ground, c.node, c.solid_mass, c.solid_change, with_water, dt));
      if (flows)
        work = sum(work, add_to_water(grid, c, ground.spec.water->fluid.density, dt));
      if (c.body_mass > 0.0)
        work = sum(work, push(ground, c.body_node, c.body_mass, c.body_change, ground.has_flow(), dt));
    }
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const ContactNode& c : nodes(b)) {
      const Vector solid = mean(c.solid_before, grid.velocity_after(c.node));
      work.impact -= c.solid_mass * dot(c.solid_change, solid);
      if (c.rubs())
        work.friction += c.tangential_impulse * dot(c.tangent(), solid);
      if (c.water_mass > 0.0)
        work.impact -=
            c.water_mass *
            dot(c.water_change, mean(c.water_before, {grid.wx_after[c.node], grid.wy_after[c.node]}));
    }
  return work;
}

double Contact::meet_remapped(Ground& ground) {
  Grid& grid = ground.grid;
  double power = 0.0;
  // Power of the forces at a node on a velocity; weight and loads, in them, are booked elsewhere.
  const auto power_on = [&](std::size_t n, const Vector& velocity, const Vector& load) {
    const double m = grid.mass[n];
    return dot({grid.force_x[n] - m * load.x, grid.force_y[n] + m * (ground.spec.gravity - load.y)},
               velocity);
  };
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const ContactNode& c : nodes(b)) {
      if (!c.closed || c.faint)
        continue;
      const std::size_t n = c.node;
      const Vector u{grid.vx_strain[n], grid.vy_strain[n]};
      const bool elastic = c.body_mass > 0.0;
      const double per_wall = elastic ? 1.0 / c.body_mass : 0.0; // a rigid body is unchanged
      const Vector wall = elastic ? Vector{grid.vx_strain[c.body_node], grid.vy_strain[c.body_node]}
                                  : bodies_[b].motion().at(c.arm);
      const Vector t = c.tangent();
      const double toward = dot(c.normal, u) - dot(c.normal, wall);
      // N of both together may not become tension, unless water bears it.
      double normal = c.mass * toward / (1.0 + c.mass * per_wall);
      if (!c.wet() || !c.tied)
        normal = std::max(normal, -c.normal_impulse);
      const double effective = c.effective_impulse + (c.mass - c.full_water) / c.mass * normal;
      const double slip = dot(t, u) - dot(t, wall);
      const bool sticks = c.tied && c.slip == 0;
      const double rest = c.bound(effective) - std::abs(c.tangential_impulse);
      const bool touches = c.tied || normal > 0.0;
      const double stick = c.tangential * slip / (1.0 + c.tangential * per_wall);
      const double limit = sticks ? std::abs(stick) : (touches ? std::max(0.0, rest) : 0.0);
      const double tangential = std::clamp(stick, -limit, limit);
      const double un = normal / c.mass;
      const double ut = tangential / c.tangential;
      const Vector taken{un * c.normal.x + ut * t.x, un * c.normal.y + ut * t.y};
      grid.vx_strain[n] -= taken.x;
      grid.vy_strain[n] -= taken.y;
      power += power_on(n, taken, c.key.against ? pull(*c.key.against) : Vector{});
      if (elastic) {
        const std::size_t m = c.body_node;
        const Vector given = per_wall * (normal * c.normal + tangential * t);
        grid.vx_strain[m] += given.x;
        grid.vy_strain[m] += given.y;
        power -= power_on(m, given, pull(b));
        if (ground.has_flow()) {
          grid.flux_x[m] = grid.vx_strain[m];
          grid.flux_y[m] = grid.vy_strain[m];
        }
      }
      if (!ground.has_flow())
        continue;
      // n w, without its part through the wall.
      Vector flow{grid.flux_x[n] - u.x, grid.flux_y[n] - u.y};
      if (touches) {
        const double through = dot(c.normal, flow);
        power += through * dot(c.normal, {grid.water_force_x[n], grid.water_force_y[n]});
        flow = flow - through * c.normal;
      }
      grid.flux_x[n] = grid.vx_strain[n] + flow.x;
      grid.flux_y[n] = grid.vy_strain[n] + flow.y;
    }
  return power;
}

double Contact::move(Ground& ground, double dt) {
  follow_particles(ground);
  double farthest = 0.0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (!elastic_[b])
      bodies_[b].move(dt);
    const PushedOut pushed = push_out(ground, surface(b), nodes_[b].may_enter());
    farthest = std::max(farthest, pushed.farthest);
    pushed_out_ += pushed.count;
  }
  return farthest;
}

// Whether nodes have been found before, then the key and the sets of each.
std::vector<double> Contact::node_state(std::size_t body) const {
  std::vector<double> state{nodes_[body].placed() ? 1.0 : 0.0};
  for (const ContactNode& c : nodes(body))
    state.insert(state.end(),
                 {c.key.against ? static_cast<double>(*c.key.against) : -1.0, static_cast<double>(c.key.row),
                  static_cast<double>(c.key.column), c.tied ? 1.0 : 0.0, static_cast<double>(c.slip)});
  return state;
}

void Contact::set_node_state(std::size_t body, const std::vector<double>& state) {
  constexpr std::size_t numbers = 5; // of a node
  std::vector<ContactNode> nodes(state.size() / numbers);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const double* const of_node = state.data() + 1 + n * numbers;
    if (of_node[0] >= 0.0)
      nodes[n].key.against = static_cast<std::size_t>(of_node[0]);
    nodes[n].key.row = static_cast<int>(of_node[1]);
    nodes[n].key.column = static_cast<int>(of_node[2]);
    nodes[n].tied = of_node[3] != 0.0;
    nodes[n].slip = static_cast<int>(of_node[4]);
  }
  nodes_[body].go_on_from(std::move(nodes), !state.empty() && state.front() != 0.0);
}

} // namespace tremolo::mpm_domain
