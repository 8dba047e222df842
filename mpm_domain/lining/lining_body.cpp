#include "mpm_domain/lining/lining_body.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/lining/beam/beam_step.hpp"
#include "mpm_domain/lining/water/water_before.hpp"
#include "mpm_domain/lining/water/water_load.hpp"
#include "mpm_domain/transfer/out_of_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

/// Mass of a node on the finest cells that the densest soil fills, kg/m.
double full_mass(const Ground& ground) {
  double density = 0.0;
  for (const Particles& set : ground.sets)
    density = std::max(density, materials::elasticity(set.law).density);
  const double h = ground.finest_lattice().h;
  return density * h * h;
}

SoilMotion after_update(const Grid& grid, std::span<const NodeFlow> flows = {}) {
  return {grid.mass, grid.vx_after, grid.vy_after, flows};
}

/// A node of the segments, and its motion after the update.
struct MetNode {
  std::size_t node;
  Vector grains, water; ///< m/s
};

std::vector<MetNode> met_nodes(const Grid& grid, std::span<const SegmentRows> rows) {
  std::vector<std::size_t> numbers;
  for (const SegmentRows& of : rows)
    for (const NodeShare& of_node : of.soil)
      numbers.push_back(of_node.node);
  std::ranges::sort(numbers);
  const auto twice = std::ranges::unique(numbers);
  numbers.erase(twice.begin(), twice.end());
  std::vector<MetNode> nodes;
  for (const std::size_t n : numbers)
    nodes.push_back({n, grid.velocity_after(n),
                     grid.traits.flowing ? Vector{grid.wx_after[n], grid.wy_after[n]} : Vector{}});
  return nodes;
}

/// Books the change of the nodes' energy by contact and corrects their accelerations; their loss counts as
/// impact, before the beam's share. Drag has been booked on the mean of w before contact.
LiningWork soil_work(Ground& ground, std::span<const MetNode> nodes, std::span<const NodeFlow> flows,
                     double kick) {
  Grid& grid = ground.grid;
  LiningWork work;
  const auto mean = [](const Vector& a, const Vector& b) { return 0.5 * (a + b); };
  for (const auto& [n, grains, water] : nodes) {
    const Vector after = grid.velocity_after(n);
    const Vector change = after - grains;
    grid.ax[n] += change.x / kick;
    grid.ay[n] += change.y / kick;
    work.kinetic += 0.5 * grid.mass[n] * (square(after) - square(grains));
    work.gravity -= 0.5 * kick * ground.spec.gravity * grid.mass[n] * change.y;
    work.impact -= grid.mass[n] * dot(change, mean(grid.velocity_before(n), after));
    const auto flow = std::ranges::lower_bound(flows, n, {}, &NodeFlow::node);
    if (flow == flows.end() || flow->node != n)
      continue;
    const Vector water_before{grid.wx_before[n], grid.wy_before[n]};
    const Vector water_after{grid.wx_after[n], grid.wy_after[n]};
    const Vector water_change = water_after - water;
    const double full = ground.spec.water->fluid.density * grid.wet_volume[n];
    const double push = kick * flow->water_mass / full;
    const Vector gained = water - water_before;
    const Vector drag{push * grid.water_force_x[n] - flow->water_mass * gained.x,
                      push * grid.water_force_y[n] - flow->water_mass * gained.y};
    work.kinetic += 0.5 * flow->water_mass * (square(water_after) - square(water));
    work.drag += 0.5 * dot(drag, water_change - change);
    work.impact -= flow->water_mass * dot(water_change, mean(water_before, water_after));
  }
  return work;
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
  near_ = particles_near(ground, box, ground.reach_of_structures());
  const double way = 2.0 * ground.sort_distance(); // of a particle and the lining towards each other
  inside_box_.clear();
  std::ranges::copy_if(near_, std::back_inserter(inside_box_), [&](const NearParticle& of) {
    const Particles& p = ground.sets[of.set];
    return p.x[of.index] > box.x_min - way && p.x[of.index] < box.x_max + way &&
           p.y[of.index] > box.y_min - way && p.y[of.index] < box.y_max + way;
  });
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
      if (const double d2 = square(Vector{p.x[k], p.y[k]} - of.position); d2 < least) {
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

std::vector<double> LiningBody::water_loads(const Ground& ground) const {
  std::vector<double> forces(beam_.positions().size(), 0.0);
  add_rest_pressure(ground, surface_.points(), beam_, forces);
  return forces;
}

std::vector<double> LiningBody::loads(const Ground& ground) const {
  std::vector<double> forces = water_loads(ground);
  if (water_share_ < 1.0)
    for (std::size_t i = 0; i < forces.size(); ++i)
      forces[i] = water_before_[i] + water_share_ * (forces[i] - water_before_[i]);
  for (std::size_t k = 0; k < beam_.node_count(); ++k) {
    const std::size_t y = beam_.first_dof(k) + 1;
    forces[y] -= ground.spec.gravity * beam_.masses()[y];
  }
  return forces;
}

void LiningBody::book_beam(const Grid& grid, std::span<const double> weight, std::span<const double> v,
                           double kick, LiningWork& work) const {
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
    work.elements += dot(impulse, of_beam);
    work.impact -= dot(impulse, of_beam);
    const SegmentContact& segment = contact_.segments()[of.segment];
    if (segment.slip == 0)
      continue;
    const Vector before = soil_velocity(of, grid.vx_before, grid.vy_before);
    const Vector after = soil_velocity(of, grid.vx_after, grid.vy_after);
    const Vector slip = 0.5 * (before + after) - of_beam;
    work.friction += segment.tangential_impulse * dot(of.tangent(), slip);
  }
}

LiningWork LiningBody::meet(Ground& ground, double kick, double dt) {
  find_segments(ground);
  Grid& grid = ground.grid;
  flows_ = find_flows(ground, rows_, kick);
  const std::vector<MetNode> nodes = met_nodes(grid, rows_);
  const WaterBefore water = find_water_before(ground, near_, surface_.bounds(), rows_, kick);
  stop_flow(ground, flows_);
  const std::vector<double> weight = loads(ground);
  const BeamStep step(beam_, kick, dt, weight);
  const SoilMotion trial = after_update(grid, flows_);
  const std::vector<double> v = contact_.meet(rows_, trial, step, kick, dt, false, water);
  for (const auto& [n, change, of_water] : contact_.changes(rows_, trial)) {
    grid.vx_after[n] += change.x;
    grid.vy_after[n] += change.y;
    if (grid.traits.flowing) {
      const bool flows = trial.flow(n) != nullptr;
      grid.wx_after[n] = flows ? grid.wx_after[n] + of_water.x : grid.vx_after[n];
      grid.wy_after[n] = flows ? grid.wy_after[n] + of_water.y : grid.vy_after[n];
    }
  }
  LiningWork work = soil_work(ground, nodes, flows_, kick);
  book_beam(grid, weight, v, kick, work);
  work.impact -= work.friction;
  contact_.follow_gaps(rows_, after_update(grid), v, dt);
  beam_.set_velocities(v);
  return work;
}

double LiningBody::meet_remapped(Ground& ground) const {
  Grid& grid = ground.grid;
  double power = 0.0;
  const SoilMotion remapped{grid.mass, grid.vx_strain, grid.vy_strain, flows_};
  // n w, without its part through the lining.
  std::vector<Vector> flow;
  for (const NodeFlow& of : flows_) {
    const std::size_t n = of.node;
    const Vector w{grid.flux_x[n] - grid.vx_strain[n], grid.flux_y[n] - grid.vy_strain[n]};
    const double through = dot(of.normal, w);
    power += through * dot(of.normal, {grid.water_force_x[n], grid.water_force_y[n]});
    flow.push_back(w - through * of.normal);
  }
  for (const auto& [n, change, water] : contact_.stopped(rows_, remapped, beam_.velocities())) {
    grid.vx_strain[n] += change.x;
    grid.vy_strain[n] += change.y;
    power -= grid.force_x[n] * change.x + (grid.force_y[n] + grid.mass[n] * ground.spec.gravity) * change.y;
    if (grid.traits.flowing) { // water that does not flow goes along
      grid.flux_x[n] = grid.vx_strain[n];
      grid.flux_y[n] = grid.vy_strain[n];
    }
  }
  for (std::size_t k = 0; k < flows_.size(); ++k) {
    const std::size_t n = flows_[k].node;
    grid.flux_x[n] = grid.vx_strain[n] + flow[k].x;
    grid.flux_y[n] = grid.vy_strain[n] + flow[k].y;
  }
  return power;
}

/// The particles in the octagon around the lining, which a ring nearly fills: a finer test would have to
/// visit all edges for each particle.
const std::vector<NearParticle>& LiningBody::near_surface(const Ground& ground) {
  constexpr double none = std::numeric_limits<double>::infinity();
  double least_sum = none, most_sum = -none, least_difference = none, most_difference = -none;
  for (const Vector& at : surface_.points()) {
    least_sum = std::min(least_sum, at.x + at.y);
    most_sum = std::max(most_sum, at.x + at.y);
    least_difference = std::min(least_difference, at.x - at.y);
    most_difference = std::max(most_difference, at.x - at.y);
  }
  suspects_.clear();
  for (const NearParticle& of : inside_box_) {
    const Particles& p = ground.sets[of.set];
    const double sum = p.x[of.index] + p.y[of.index];
    const double difference = p.x[of.index] - p.y[of.index];
    if (sum >= least_sum && sum <= most_sum && difference >= least_difference &&
        difference <= most_difference)
      suspects_.push_back(of);
  }
  return suspects_;
}

double LiningBody::move(Ground& ground, double dt) {
  beam_.move(dt);
  surface_.place(carried_.corners(beam_));
  const PushedOut pushed = push_out(ground, surface_, near_surface(ground));
  pushed_out_ += pushed.count;
  return pushed.farthest;
}

double LiningBody::relax(Ground& ground, double keep, double gain, double dt, bool bonded,
                         std::span<const unsigned char> left_out) {
  Grid& grid = ground.grid;
  const BeamStep step(beam_, gain, dt, loads(ground), keep);
  const std::vector<double> v = contact_.meet(rows_, after_update(grid), step, gain, dt, bonded);
  double unbalanced = 0.0;
  for (const auto& [n, change, water] : contact_.changes(rows_, after_update(grid))) {
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
  beam_.set_velocities(std::vector<double>(beam_.positions().size(), 0.0));
}

void LiningBody::carry_over(const LiningBody& before, const Ground& model_before) {
  set_state(before.state());
  water_before_ = before.water_loads(model_before);
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
