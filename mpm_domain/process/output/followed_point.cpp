#include "mpm_domain/process/output/followed_point.hpp"

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tremolo::mpm_domain {

WaterState water_state(const Particles& set, std::size_t k) {
  WaterState state;
  if (set.traits.wet) {
    state.pressure = set.water->pressure(set.pore_pressure[k]);
    state.excess = excess_pressure(set, k);
    state.ratio = set.vertical_at_rest[k] < 0.0 ? state.excess / -set.vertical_at_rest[k] : 0.0;
  }
  if (set.traits.flowing) {
    const double porosity = set.water->porosity(set.mass[k], set.volume[k]);
    state.flux = {porosity * (set.wx[k] - set.vx[k]), porosity * (set.wy[k] - set.vy[k])};
    if (set.traits.seeping) { // the velocity of the water counts from its steady flow
      const double k_darcy = set.water->pores.permeability;
      state.flux = {state.flux.x - k_darcy * set.head_slope_x[k],
                    state.flux.y - k_darcy * set.head_slope_y[k]};
    }
  }
  return state;
}

double largest_pressure_ratio(const Ground& ground) {
  double largest = 0.0;
  for (const Particles& set : ground.sets_of_soil()) {
    if (!set.traits.wet)
      continue;
    const double of_a_cell = set.water->unit_weight * set.cell_size;
    for (std::size_t k = 0; k < set.size(); ++k)
      largest = std::max(largest, std::abs(water_state(set, k).excess) /
                                      std::max(-set.vertical_at_rest[k], of_a_cell));
  }
  take_largest(ground, {&largest, 1});
  return largest;
}

Vector position_of(const Particles& set, std::size_t k, double dt) {
  return {set.x[k] - 0.5 * dt * set.vx[k], set.y[k] - 0.5 * dt * set.vy[k]};
}

Vector displacement(const Particles& set, std::size_t k, double dt) {
  const auto [x, y] = position_of(set, k, dt);
  return {x - set.x_initial[k], y - set.y_initial[k]};
}

ParticleMotion motion_in_space(const Snapshot& snapshot, ParticleName particle, const Stepper& stepper) {
  const auto& [s, id] = particle;
  const Particles& set = snapshot.sets()[s];
  const std::size_t k = set.index_of[id];
  const double dt = stepper.dt();
  const double n = stepper.speed_of_time();
  const BaseMotion base = stepper.domain().boundary.base_motion();
  const auto sum = [](Vector p, Vector q, double unit) { return (p + q) / unit; };
  return {position_of(set, k, dt), sum(displacement(set, k, dt), base.displacement, 1.0),
          sum(snapshot.velocity(s, k), base.velocity, n),
          sum(snapshot.acceleration(s, k), base.acceleration, n * n)};
}

FollowedPoint::FollowedPoint(Domain& domain, std::span<const Particles> sets, scene::Point point,
                             std::optional<std::size_t> structure) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const Particles& set = sets[s];
    const auto body = set.body ? std::optional(domain.contact.structure_of(*set.body)) : std::nullopt;
    if (body != structure)
      continue;
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double distance = std::hypot(set.x[k] - point.x, set.y[k] - point.y);
      if (distance < nearest) {
        nearest = distance;
        set_ = s;
        id_ = set.id[k];
      }
    }
  }
  keep_whole(domain, set_, id_);
  find_neighbours(sets[set_]);
}

void FollowedPoint::find_neighbours(const Particles& set) {
  const std::size_t own = set.index_of[id_];
  // The eight around it on an even grid of particles, whose distance is twice half_size. Positions are those
  // of now, before anything is shaken: x_initial already has the settlement under loads, but not in a resumed
  // run.
  const double reach = reach_of_neighbours * 2.0 * set.half_size;
  for (std::size_t k = 0; k < set.size(); ++k) {
    const Vector offset{set.x[k] - set.x[own], set.y[k] - set.y[own]};
    if (k != own && std::hypot(offset.x, offset.y) < reach)
      neighbours_.push_back({set.id[k], offset});
  }
}

std::vector<OutputColumn> FollowedPoint::columns(const scene::Case& scene) {
  std::vector<OutputColumn> columns(followed_point_columns.begin(), followed_point_columns.end());
  if (scene.water)
    columns.insert(columns.end(), followed_water_columns.begin(), followed_water_columns.end());
  return columns;
}

void FollowedPoint::add_followed(std::vector<ParticleName>& to) const {
  to.push_back({set_, id_});
  for (const Neighbour& neighbour : neighbours_)
    to.push_back({set_, neighbour.id});
}

void FollowedPoint::append_values(const Snapshot& snapshot, const Stepper& stepper, bool water,
                                  std::vector<double>& row) const {
  const Particles& set = snapshot.sets()[set_];
  const std::size_t k = set.index_of[id_];
  const double dt = stepper.dt();
  const auto [x, u, v, a] = motion_in_space(snapshot, {set_, id_}, stepper);
  const Strain e = strain(set, dt);
  row.insert(row.end(), {x.x, x.y, u.x, u.y, v.x, v.y, a.x, a.y, set.sxx[k], set.syy[k], set.szz[k],
                         set.sxy[k], e.xx, e.yy, e.xy});
  if (water) {
    const WaterState state = water_state(set, k);
    row.insert(row.end(), {state.pressure, state.ratio});
  }
}

FollowedPoint::Strain FollowedPoint::strain(const Particles& set, double dt) const {
  const Vector own = displacement(set, set.index_of[id_], dt);
  double ux_x = 0.0, ux_y = 0.0, uy_x = 0.0, uy_y = 0.0; // sum of u X^T
  double xx = 0.0, xy = 0.0, yy = 0.0;                   // sum of X X^T
  for (const Neighbour& neighbour : neighbours_) {
    const std::uint32_t k = set.index_of[neighbour.id];
    if (k == Particles::nowhere)
      continue;
    const Vector u = displacement(set, k, dt);
    const Vector d = neighbour.offset;
    ux_x += (u.x - own.x) * d.x;
    ux_y += (u.x - own.x) * d.y;
    uy_x += (u.y - own.y) * d.x;
    uy_y += (u.y - own.y) * d.y;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
  }
  const double determinant = xx * yy - xy * xy;
  constexpr double nearly_on_a_line = 1e-6;
  if (!(determinant > nearly_on_a_line * (xx + yy) * (xx + yy))) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  return {(ux_x * yy - ux_y * xy) / determinant, (uy_y * xx - uy_x * xy) / determinant,
          (ux_y * xx - ux_x * xy + uy_x * yy - uy_y * xy) / determinant};
}

} // namespace tremolo::mpm_domain
