#include "mpm_domain/prop/fastened_end.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/particles/bounds.hpp"
#include "mpm_domain/prop/particle_nodes.hpp"
#include "mpm_domain/ranks/lists_of_all.hpp"

#include <Eigen/Dense>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// A particle near a point.
struct Near {
  std::size_t set;
  std::uint32_t id;
  double mass; ///< kg/m
  Vector position;
  bool touches; ///< the point

  Eigen::Vector2d at() const { return {position.x, position.y}; }
};

/// Particles of some sets whose middles lie within a cell and one of their own sides; none unless one of them
/// touches the point. Ranks have filled soil together, and each has the elastic bodies.
std::vector<Near> particles_around(const Vector& position, const Ground& ground, std::size_t first,
                                   std::size_t end) {
  std::vector<Near> near;
  for (std::size_t s = first; s < end; ++s) {
    const Particles& set = ground.sets[s];
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double distance = std::hypot(set.x[k] - position.x, set.y[k] - position.y);
      if (distance < set.cell_size + 2.0 * set.half_size)
        near.push_back({s, set.id[k], set.mass[k], {set.x[k], set.y[k]}, distance < 2.0 * set.half_size});
    }
  }
  if (ground.share && first < ground.soil_sets) {
    near = lists_of_all(*ground.share->ranks, near);
    std::ranges::stable_sort(near, {}, &Near::set); // as one process finds them
  }
  return std::ranges::any_of(near, &Near::touches) ? near : std::vector<Near>{};
}

} // namespace

FastenedEnd::FastenedEnd(const PropFastening& fastening, Ground& ground, const Contact& contact) {
  if (fastening.structure.empty()) {
    hold_particles(fastening.position, ground, 0, ground.soil_sets);
    return;
  }
  const std::vector<Structure>& structures = ground.spec.structures;
  const auto found = std::ranges::find(structures, fastening.structure, &Structure::name);
  if (found == structures.end())
    throw std::invalid_argument(
        fmt::format("a prop is fastened to the structure '{}', which is not there", fastening.structure));
  if (found->stiffness) {
    const auto number = static_cast<std::size_t>(std::count_if(
        structures.begin(), found, [](const Structure& one) { return one.stiffness.has_value(); }));
    const std::span<const Particles> of_body = ground.sets_of_body(number);
    const auto first = static_cast<std::size_t>(of_body.data() - ground.sets.data());
    hold_particles(fastening.position, ground, first, first + of_body.size());
    return;
  }
  body_ = static_cast<std::size_t>(found - structures.begin());
  const RigidBody& body = contact.bodies()[*body_];
  arm_ = fastening.position - body.start();
  mobility_ = 1.0 / body.mass() + square(arm_) / body.inertia();
}

void FastenedEnd::hold_particles(const Vector& position, Ground& ground, std::size_t first_set,
                                 std::size_t end_set) {
  const std::vector<Near> near = particles_around(position, ground, first_set, end_set);
  const auto refuse = [&](const char* what) {
    throw std::invalid_argument(
        fmt::format("a prop is fastened at ({:.6g}, {:.6g}) m, where there is {} to hold on to", position.x,
                    position.y, what));
  };
  if (near.empty())
    refuse("nothing");
  double mass = 0.0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
  for (const Near& one : near) {
    mass += one.mass;
    centroid += one.mass * one.at();
  }
  centroid /= mass;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Near& one : near) {
    const Eigen::Vector2d from = one.at() - centroid;
    spread += one.mass / mass * from * from.transpose();
  }
  if (!(spread.determinant() > 1e-6 * spread.trace() * spread.trace()))
    refuse("a single row of particles");
  const Eigen::Vector2d slope = spread.inverse() * (Eigen::Vector2d(position.x, position.y) - centroid);
  for (const Near& one : near) {
    const double share = one.mass / mass * (1.0 + slope.dot(one.at() - centroid));
    held_.push_back({one.set, one.id, share, one.position.x});
    mobility_ += share * share / one.mass;
    keep_whole(ground, one.set, one.id);
  }
}

Vector FastenedEnd::arm(const RigidBody& body) const {
  const double c = std::cos(body.tilt());
  const double s = std::sin(body.tilt());
  return {c * arm_.x - s * arm_.y, s * arm_.x + c * arm_.y};
}

Vector FastenedEnd::position(const Ground& ground, const Contact& contact) const {
  if (body_)
    return contact.bodies()[*body_].centre() + arm(contact.bodies()[*body_]);
  const double period = ground.spec.box.x_max - ground.spec.box.x_min;
  Vector position;
  for (const Held& one : held_) {
    const Particles& set = ground.sets[one.set];
    const std::size_t k = set.index_of[one.id];
    double x = set.x[k];
    if (ground.spec.periodic()) // where it would be had it not come in again on the other side
      x -= period * std::round((x - one.start_x) / period);
    position += one.share * Vector{x, set.y[k]};
  }
  return position;
}

std::optional<mesh::Rectangle> FastenedEnd::bounds(const Ground& ground) const {
  if (body_)
    return std::nullopt;
  mesh::Rectangle box = around_nothing;
  for (const Held& one : held_) {
    const Particles& set = ground.sets[one.set];
    if (const std::size_t k = set.index_of[one.id]; k != Particles::nowhere)
      reach_around(box, set.x[k], set.y[k]);
  }
  return box;
}

void FastenedEnd::follow(const Ground& ground) {
  nodes_.clear();
  for (const Held& one : held_)
    add_nodes(ground, one.set, ground.sets[one.set].index_of[one.id], one.share, nodes_);
}

Vector FastenedEnd::velocity(const Ground& ground, const Contact& contact) const {
  if (body_)
    return contact.bodies()[*body_].motion().at(arm(contact.bodies()[*body_]));
  Vector velocity;
  for (const auto& [node, share] : nodes_)
    velocity += share * ground.grid.velocity_after(node);
  return velocity;
}

void FastenedEnd::pull_nodes(Ground& ground, const Vector& force) const {
  for (const auto& [node, share] : nodes_) {
    ground.grid.force_x[node] += share * force.x;
    ground.grid.force_y[node] += share * force.y;
  }
}

} // namespace tremolo::mpm_domain
