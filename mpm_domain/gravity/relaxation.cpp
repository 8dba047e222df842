#include "mpm_domain/gravity/relaxation.hpp"

#include "mpm_domain/dispersion/fullness.hpp"
#include "mpm_domain/gravity/surface_line.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/ranks/lists_of_all.hpp"
#include "mpm_domain/spec/growth.hpp"
#include "mpm_domain/spec/held_nodes.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/strain/relaxation_stress.hpp"
#include "mpm_domain/tiles/totals.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "mpm_domain/transfer/sharp_transfer.hpp"
#include "mpm_domain/water/pore_pressure.hpp"
#include "mpm_domain/water/seepage_force.hpp"
#include "mpm_domain/water/water_scatter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tremolo::mpm_domain {

namespace {

/// Steps between two looks at the residual.
constexpr long report_every = 100;

/// The geometry of particles, which stays the same.
constexpr std::array given_fields{&ParticleFields::volume, &ParticleFields::box_xx, &ParticleFields::box_xy,
                                  &ParticleFields::box_yy};

/// The longest time allowed, relative to the given one.
constexpr double most_patience = 8.0;

/// Time limit of a relaxation. A long body, or one close to its limit load, comes to rest slowly: the
/// residual of a stable body vanishes, that of a failing one tends to the driving force.
class Patience {
public:
  explicit Patience(const Course& course)
      : time_(course.time), longest_(most_patience * course.time), falling_(course.falling) {}

  bool is_over(double passed, double residual) {
    if (passed < 0.5 * time_)
      half_way_ = residual;
    if (passed < time_)
      return false;
    if (!(residual < falling_ * half_way_) || time_ >= longest_)
      return true;
    half_way_ = residual;
    time_ *= 2.0;
    return false;
  }

private:
  double time_; ///< s
  double longest_;
  double falling_;
  double half_way_ = 0.0; ///< residual at half of the time
};

} // namespace

Relaxation::Relaxation(Domain& domain) : domain_(domain), has_structures_(domain.has_structures_here()) {
  for (Particles& set : domain.sets) {
    laws_.push_back(set.law);
    set.law = materials::without_softening(set.law);
    // The way to rest has a damping of its own, on mass. Soil then has the stiffness at the reference
    // frequency of constant damping.
    set.damping_time = 0.0;
    forget(set);
    set.relaxation = {};
    ParticleFields& given = given_.emplace_back();
    for (const auto field : given_fields)
      given.*field = set.*field;
  }
  scatter(domain, ScatterPart::motion);
  if (domain.is_sharp())
    find_fullness(domain);
  if (domain.has_seepage())
    scatter_seepage(domain, domain.soil_rows, domain.soil_ties);
  if (has_structures_) {
    domain.contact.begin_rest(domain);
    domain.linings.begin_rest(domain);
  }
  stop_nodes();
  find_supports();
  const double depth = domain.spec.box.y_max - domain.spec.box.y_min;
  double slowest = domain.fastest_wave();
  take_largest(domain, {&slowest, 1});
  for (const Particles& set : domain.sets)
    slowest = std::min(slowest, materials::elasticity(set.law).s_wave_speed());
  alpha_ = std::numbers::pi * slowest / depth;
  drained_step_ = domain.spec.scheme.fraction * critical_skeleton_step(domain);
}

void Relaxation::stop_nodes() {
  for (const auto& [begin, end] : domain_.soil_rows)
    for (NodeField* velocity : {&domain_.grid.vx_after, &domain_.grid.vy_after})
      std::fill(velocity->data() + begin, velocity->data() + end, 0.0);
}

void Relaxation::find_supports() {
  for (ZeroPages<unsigned char>* marks :
       {&supports_.fixed_x, &supports_.fixed_y, &supports_.full, &supports_.met, &supports_.skin})
    set_to_zeros(*marks, domain_.grid.size());
  if (has_structures_)
    find_met_nodes();
  for (int level = 0; level < domain_.lattice_count(); ++level)
    find_supports(domain_.lattice(level));
}

void Relaxation::find_met_nodes() {
  for (std::size_t b = 0; b < domain_.contact.bodies().size(); ++b)
    for (const ContactNode& contact : domain_.contact.nodes(b)) {
      supports_.met[contact.node] = 1;
      if (contact.body_mass > 0.0)
        supports_.met[contact.body_node] = 1;
    }
  for (const LiningBody& lining : domain_.linings.bodies())
    for (const SegmentRows& rows : lining.rows())
      for (const NodeShare& of_node : rows.soil)
        supports_.met[of_node.node] = 1;
}

void Relaxation::find_supports(const Lattice& lattice) {
  const double empty = empty_mass(domain_);
  for (int j = 0; j < lattice.ny; ++j)
    for (int i = 0; i < lattice.nx; ++i) {
      const std::size_t n = lattice.index(i, j);
      if (domain_.grid.mass[n] <= empty)
        continue;
      supports_.full[n] = 1;
      const Hold hold = hold_of(lattice, i, j, domain_.spec, HeldNodes::on_lines);
      supports_.fixed_y[n] = hold == Hold::all;
      supports_.fixed_x[n] = hold != Hold::none;
      if (hold != Hold::none)
        (hold == Hold::all ? held_by_.base : held_by_.sides).push_back(n);
    }
}

void Relaxation::find_skin(double cells) {
  double widest = 0.0;
  for (const Particles& set : domain_.sets_of_soil())
    widest = std::max(widest, 2.0 * set.half_size);
  SurfaceLine surface(widest);
  for (const Particles& set : domain_.sets_of_soil())
    for (std::size_t k = 0; k < set.size(); ++k)
      surface.add({set.x[k], set.y[k]}, 2.0 * set.half_size);
  for (int level = 0; level < domain_.lattice_count(); ++level) {
    const Lattice& lattice = domain_.lattice(level);
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx; ++i)
        supports_.skin[lattice.index(i, j)] =
            lattice.y0 + j * lattice.h > surface.at(lattice.x0 + i * lattice.h) - cells * lattice.h;
  }
}

void Relaxation::find_forces() {
  domain_.is_sharp() ? scatter_sharp_forces(domain_) : scatter(domain_, ScatterPart::force);
  if (domain_.has_seepage())
    add_seepage(domain_, domain_.soil_rows);
  if (!has_structures_)
    return;
  domain_.loads.add(domain_.grid);
  add_loads(domain_.contact, domain_);
  domain_.props.act(domain_, domain_.contact);
}

std::vector<Vector> Relaxation::forces() {
  find_forces();
  std::vector<double> x(domain_.grid.force_x.begin(), domain_.grid.force_x.end());
  std::vector<double> y(domain_.grid.force_y.begin(), domain_.grid.force_y.end());
  take_nodes_of_all(domain_, x);
  take_nodes_of_all(domain_, y);
  std::vector<Vector> forces(domain_.grid.size());
  for (std::size_t n = 0; n < forces.size(); ++n)
    forces[n] = {x[n], y[n]};
  return forces;
}

/// Adds what is left of c.
void Relaxation::add_held(double share) {
  for (std::size_t n = 0; n < held_.size(); ++n) {
    if (!supports_.full[n])
      continue; // no soil is there to be held, and nothing would take the force away again
    domain_.grid.force_x[n] += (1.0 - share) * held_[n].x;
    domain_.grid.force_y[n] += (1.0 - share) * held_[n].y;
  }
}

/// One step on the grid and of the structures; returns the residual: ||f|| over free directions by ||m g||
/// over all nodes. Forces of a structure and of the nodes that it touches count with what contact adds.
double Relaxation::relax_grid(bool bonded) {
  Grid& grid = domain_.grid;
  const double keep = (1.0 - 0.5 * alpha_ * dt_) / (1.0 + 0.5 * alpha_ * dt_);
  const double gain = kick();
  ExactSums<2> squares = sum_over_rows<2>(domain_, domain_.soil_rows, [&](const NodeRange& nodes) {
    double unbalanced = 0.0;
    double applied = 0.0;
    for (std::size_t n = nodes.begin; n < nodes.end; ++n) {
      if (!supports_.full[n])
        continue;
      const double m = grid.mass[n];
      const Vector v = grid.velocity_after(n);
      const double fx = supports_.fixed_x[n] ? 0.0 : grid.force_x[n];
      const double fy = supports_.fixed_y[n] ? 0.0 : grid.force_y[n];
      grid.vx_after[n] = supports_.fixed_x[n] ? 0.0 : keep * v.x + gain * fx / m;
      grid.vy_after[n] = supports_.fixed_y[n] ? 0.0 : keep * v.y + gain * fy / m;
      if (!supports_.met[n] && !supports_.skin[n])
        unbalanced += fx * fx + fy * fy;
      applied += m * m * domain_.spec.gravity * domain_.spec.gravity;
    }
    return std::array{unbalanced, applied};
  });
  if (has_structures_ && domain_.contact.any())
    squares[0].add(domain_.contact.relax(domain_, keep, gain, bonded, supports_.skin));
  if (has_structures_ && domain_.linings.any())
    squares[0].add(domain_.linings.relax(domain_, keep, gain, dt_, bonded, supports_.skin));
  add_over_ranks(domain_, squares);
  return std::sqrt(squares[0].value() / squares[1].value());
}

/// Strains soil by the velocity of the nodes.
void Relaxation::strain(bool undrained) {
  if (domain_.is_sharp()) {
    for (const auto& [begin, end] : domain_.soil_rows) {
      std::copy_n(domain_.grid.vx_after.begin() + begin, end - begin, domain_.grid.vx_strain.begin() + begin);
      std::copy_n(domain_.grid.vy_after.begin() + begin, end - begin, domain_.grid.vy_strain.begin() + begin);
    }
    sharpen_strain(domain_);
    gather(domain_, dt_, {.strain = true, .remapped = true, .sharp = true});
  } else {
    gather(domain_, dt_, {.strain = true});
  }
  if (undrained)
    update_pressures(domain_, dt_, domain_.grid.vx_after, domain_.grid.vy_after, domain_.soil_rows,
                     domain_.soil_ties);
  for (std::size_t s = 0; s < domain_.sets.size(); ++s)
    for (const auto field : given_fields)
      domain_.sets[s].*field = given_[s].*field;
}

Relaxed Relaxation::run(const Course& course, const GravityProgress& progress) {
  const bool undrained = course.undrained.any && domain_.has_pore_pressure();
  for (Particles& set : domain_.sets)
    set.drains = !course.undrained.include(set.soil);
  dt_ = drained_step_;
  if (undrained) {
    dt_ = domain_.spec.scheme.fraction * critical_time_step(domain_, 0.0);
    // The pore volumes of the nodes are needed.
    scatter_mixture(domain_, domain_.soil_rows, domain_.soil_ties);
    scatter(domain_, ScatterPart::motion);
  }
  if (course.skin > 0.0)
    find_skin(course.skin);
  Patience patience(course);
  double share = course.ramp > 0.0 ? 0.0 : 1.0;
  for (long step = 0;; ++step) {
    const double passed = static_cast<double>(step) * dt_;
    if (passed < course.ramp + dt_ && course.ramp > 0.0) {
      share = ramped(passed / course.ramp);
      if (course.grow)
        course.grow(share);
    }
    find_forces();
    add_held(share);
    const Relaxed relaxed{course.first + step, relax_grid(course.bonded)};
    prolong(domain_, NodeGroup::velocity);
    const bool grows = passed < course.ramp;
    const bool late = patience.is_over(passed, relaxed.residual);
    const bool ends = !grows && (relaxed.residual < course.residual || late);
    if (ends || relaxed.step % report_every == 0)
      progress(relaxed.step, relaxed.residual);
    if (ends) {
      held_.clear();
      return relaxed;
    }
    add_way();
    if (has_structures_)
      domain_.props.follow_velocity(domain_, domain_.contact, dt_);
    strain(undrained);
  }
}

void Relaxation::count_way() {
  if (!way_x_.empty())
    return;
  set_to_zeros(way_x_, domain_.grid.size());
  set_to_zeros(way_y_, domain_.grid.size());
  for (std::size_t b = 0; b < domain_.contact.bodies().size(); ++b)
    if (!domain_.contact.is_elastic(b))
      structure_ways_.push_back({domain_.contact.bodies()[b].name(), {}});
}

void Relaxation::add_way() {
  if (!way_x_.empty())
    for (const auto& [begin, end] : domain_.soil_rows)
      for (std::size_t n = begin; n < end; ++n) {
        way_x_[n] += dt_ * domain_.grid.vx_after[n];
        way_y_[n] += dt_ * domain_.grid.vy_after[n];
      }
  for (StructureWay& structure : structure_ways_) {
    const RigidMotion& u =
        std::ranges::find(domain_.contact.bodies(), structure.name, &RigidBody::name)->motion();
    structure.way.x += dt_ * u.velocity.x;
    structure.way.y += dt_ * u.velocity.y;
    structure.turn += dt_ * u.spin;
  }
}

/// u_p = sum S u_i: particles keep their positions, and have come from others.
void Relaxation::take_way_as_displacement() {
  for (const auto& [begin, end] : domain_.soil_rows)
    for (std::size_t n = begin; n < end; ++n) {
      domain_.grid.vx_after[n] = way_x_[n];
      domain_.grid.vy_after[n] = way_y_[n];
    }
  take_velocities_of_nodes(domain_);
  for (Particles& set : domain_.sets) {
    for (std::size_t k = 0; k < set.size(); ++k) {
      set.x_initial[k] -= set.vx[k];
      set.y_initial[k] -= set.vy[k];
    }
    for (std::vector<double>* field : {&set.vx, &set.vy, &set.bxx, &set.bxy, &set.byx, &set.byy})
      std::ranges::fill(*field, 0.0);
  }
  stop_nodes();
}

namespace {

/// The force of a support on a node.
struct NodeReaction {
  std::size_t node;
  bool of_base;
  Vector force; ///< N/m
};

} // namespace

Reactions Relaxation::reactions() const {
  const Grid& grid = domain_.grid;
  std::vector<NodeReaction> held;
  for (const std::size_t n : held_by_.base)
    if (domain_.counts({n, n + 1}))
      held.push_back({n, true, {-grid.force_x[n], -grid.force_y[n]}});
  for (const std::size_t n : held_by_.sides)
    if (domain_.counts({n, n + 1}))
      held.push_back({n, false, {-grid.force_x[n], 0.0}});
  if (domain_.share) {
    held = lists_of_all(*domain_.share->ranks, held);
    std::ranges::sort(held, {}, &NodeReaction::node);
  }
  Reactions reactions;
  for (const bool of_base : {true, false})
    for (const NodeReaction& one : held)
      if (one.of_base == of_base) {
        (of_base ? reactions.base : reactions.sides).push_back(one.node);
        reactions.force.push_back(one.force);
      }
  return reactions;
}

void Relaxation::finish() {
  for (std::size_t s = 0; s < domain_.sets.size(); ++s) {
    Particles& set = domain_.sets[s];
    set.law = laws_[s];
    set.drains = false;
    if (!set.body) {
      set.damping_time = domain_.spec.soils[set.soil_index].damping_time;
      set.relaxation = domain_.spec.soils[set.soil_index].relaxation;
    }
  }
  if (!way_x_.empty())
    take_way_as_displacement();
}

} // namespace tremolo::mpm_domain
