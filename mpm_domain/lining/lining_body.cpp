#include "mpm_domain/lining/lining_body.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/lining/beam/beam_step.hpp"
#include "mpm_domain/transfer/out_of_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

Vector difference(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y};
}

/// Mass of a node on the finest cells that the densest soil fills, kg/m.
double full_mass(const Ground& ground) {
  double density = 0.0;
  for (const Particles& set : ground.sets)
    density = std::max(density, materials::elasticity(set.law).density);
  const double h = ground.finest_lattice().h;
  return density * h * h;
}

SoilMotion after_update(const Grid& grid) {
  return {grid.mass, grid.vx_after, grid.vy_after};
}

} // namespace

LiningBody::LiningBody(const Lining& lining, const Ground& ground)
    : lining_(lining), beam_(shape_of(lining), lining.section),
      carried_(lining, beam_, ground.finest_lattice().h), surface_(lining.outline), contact_(carried_) {}

double LiningBody::fastest_point() const {
  double speed2 = 0.0;
  for (std::size_t k = 0; k < beam_.node_count(); ++k)
    speed2 = std::max(speed2, square(beam_.velocity(k)));
  return std::sqrt(speed2);
}

void LiningBody::follow_sort(const Ground& ground) {
  const mesh::Rectangle box = surface_.bounds();
  const Lattice& lattice = ground.finest_lattice();
  const double margin = 4.0 * lattice.h + 2.0 * ground.sort_distance();
  near_ = particles_near(ground, box, margin);
  const double right = lattice.x0 + (lattice.nx - 1) * lattice.h;
  const double top = lattice.y0 + (lattice.ny - 1) * lattice.h;
  if (box.x_min < lattice.x0 || box.x_max > right || box.y_min < lattice.y0 || box.y_max > top)
    throw OutOfReach(fmt::format("lining '{}' has left the mesh: it reaches from x = {:.6g} m, y = {:.6g} m "
                                 "to x = {:.6g} m, y = {:.6g} m; a mesh that reaches farther holds it",
                                 lining_.name, box.x_min, box.y_min, box.x_max, box.y_max));
}

/// Each segment takes friction and adhesion of the soil of the particle that is next to its middle.
void LiningBody::take_soils(const Ground& ground) {
  const bool alike =
      std::ranges::adjacent_find(lining_.friction, std::not_equal_to{}) == lining_.friction.end() &&
      std::ranges::adjacent_find(lining_.adhesion, std::not_equal_to{}) == lining_.adhesion.end();
  for (const SegmentRows& of : rows_) {
    std::size_t soil = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; !alike && n < near_.size(); ++n) {
      const Particles& p = ground.sets[near_[n].set];
      const std::size_t k = near_[n].index;
      if (const double d2 = square(difference({p.x[k], p.y[k]}, of.place)); d2 < least) {
        least = d2;
        soil = p.soil_index;
      }
    }
    contact_.segments()[of.segment].friction = lining_.friction[soil];
    contact_.segments()[of.segment].adhesion = lining_.adhesion[soil];
  }
}

void LiningBody::find_segments(const Ground& ground) {
  rows_ = find_rows(carried_, beam_, ground.finest_lattice(), ground.grid.mass, full_mass(ground));
  take_soils(ground);
}

std::vector<double> LiningBody::weights(const Ground& ground) const {
  std::vector<double> forces(beam_.places().size(), 0.0);
  for (std::size_t k = 0; k < beam_.node_count(); ++k) {
    const std::size_t y = beam_.first_dof(k) + 1;
    forces[y] = -ground.spec.gravity * beam_.masses()[y];
  }
  return forces;
}

LiningWork LiningBody::meet(Ground& ground, double kick, double dt) {
  find_segments(ground);
  Grid& grid = ground.grid;
  const std::vector<double> weight = weights(ground);
  const BeamStep step(beam_, kick, dt, weight);
  const std::vector<double> v = contact_.meet(rows_, after_update(grid), step, kick, dt, false);
  LiningWork work;
  for (const auto& [n, change] : contact_.changes(rows_, grid.mass)) {
    const Vector trial = grid.velocity_after(n);
    grid.vx_after[n] += change.x;
    grid.vy_after[n] += change.y;
    grid.ax[n] += change.x / kick;
    grid.ay[n] += change.y / kick;
    work.kinetic += 0.5 * grid.mass[n] * (square(grid.velocity_after(n)) - square(trial));
    work.gravity -= 0.5 * kick * ground.spec.gravity * grid.mass[n] * change.y;
  }
  std::vector<double> middle(v.size());
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double before = beam_.velocities()[i];
    middle[i] = 0.5 * (before + v[i]);
    work.gravity += kick * weight[i] * middle[i];
    work.elements += middle[i] * (kick * weight[i] - beam_.masses()[i] * (v[i] - before));
  }
  for (const SegmentRows& of : rows_) {
    const Vector impulse = contact_.impulse(of);
    const Vector of_beam = beam_velocity(of, middle);
    const Vector before = soil_velocity(of, grid.vx_before, grid.vy_before);
    const Vector after = soil_velocity(of, grid.vx_after, grid.vy_after);
    const Vector slip{0.5 * (before.x + after.x) - of_beam.x, 0.5 * (before.y + after.y) - of_beam.y};
    work.elements += dot(impulse, of_beam);
    work.impact += dot(impulse, slip);
    if (const SegmentContact& segment = contact_.segments()[of.segment]; segment.slip != 0)
      work.friction += segment.tangential_impulse * dot(of.tangent(), slip);
  }
  work.impact -= work.friction;
  contact_.follow_gaps(rows_, after_update(grid), v, dt);
  beam_.set_velocities(v);
  return work;
}

double LiningBody::meet_remapped(Ground& ground) const {
  Grid& grid = ground.grid;
  double power = 0.0;
  const SoilMotion remapped{grid.mass, grid.vx_strain, grid.vy_strain};
  for (const auto& [n, change] : contact_.stopped(rows_, remapped, beam_.velocities())) {
    grid.vx_strain[n] += change.x;
    grid.vy_strain[n] += change.y;
    power -= grid.force_x[n] * change.x + (grid.force_y[n] + grid.mass[n] * ground.spec.gravity) * change.y;
  }
  return power;
}

double LiningBody::move(Ground& ground, double dt) {
  beam_.move(dt);
  surface_.place(carried_.corners(beam_));
  const PushedOut pushed = push_out(ground, surface_, near_);
  pushed_out_ += pushed.count;
  return pushed.farthest;
}

double LiningBody::relax(Ground& ground, double keep, double gain, double dt, bool bonded,
                         std::span<const unsigned char> left_out) {
  Grid& grid = ground.grid;
  const BeamStep step(beam_, gain, dt, weights(ground), keep);
  const std::vector<double> v = contact_.meet(rows_, after_update(grid), step, gain, dt, bonded);
  double unbalanced = 0.0;
  for (const auto& [n, change] : contact_.changes(rows_, grid.mass)) {
    const double inertia = grid.mass[n] / gain;
    grid.vx_after[n] += change.x;
    grid.vy_after[n] += change.y;
    if (!left_out[n])
      unbalanced += square({grid.force_x[n] + inertia * change.x, grid.force_y[n] + inertia * change.y});
  }
  // Moments count by the size of an element.
  const double size2 = beam_.elements().front().length * beam_.elements().front().length;
  std::vector<double> per_length2(v.size(), 1.0 / size2);
  for (std::size_t k = 0; k < beam_.node_count(); ++k)
    per_length2[beam_.first_dof(k)] = per_length2[beam_.first_dof(k) + 1] = 1.0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double force = beam_.masses()[i] / gain * (v[i] - keep * beam_.velocities()[i]);
    unbalanced += per_length2[i] * force * force;
  }
  beam_.set_velocities(v);
  beam_.strain_in_place(dt);
  return unbalanced;
}

void LiningBody::end_rest() {
  beam_.set_velocities(std::vector<double>(beam_.places().size(), 0.0));
}

std::vector<double> LiningBody::state() const {
  std::vector<double> state = contact_.state();
  const std::vector<double> of_beam = beam_.state();
  state.insert(state.end(), of_beam.begin(), of_beam.end());
  return state;
}

void LiningBody::set_state(std::span<const double> state) {
  const std::size_t of_contact = std::min(contact_.state().size(), state.size());
  contact_.set_state(state.first(of_contact));
  beam_.set_state(state.subspan(of_contact));
  surface_.place(carried_.corners(beam_));
}

} // namespace tremolo::mpm_domain
