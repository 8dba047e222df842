#include "mpm_domain/contact/contact_nodes.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/kernel/kernel.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>

namespace tremolo::mpm_domain {

namespace {

/// Particles belong to the surface of the soil if they are not farther from the body than the nearest by this
/// share of their size.
constexpr double surface_layer = 0.8;
/// Normals of soil and body whose cosine is below this are far apart.
constexpr double far_apart = 0.85;

double length(const Vector& v) {
  return std::hypot(v.x, v.y);
}

Vector unit(const Vector& v) {
  const double scale = 1.0 / length(v);
  return scale * v;
}

bool lies_in(const mesh::Rectangle& box, const Particles& p, std::size_t k) {
  return p.x[k] > box.x_min && p.x[k] < box.x_max && p.y[k] > box.y_min && p.y[k] < box.y_max;
}

/// Particles of an elastic structure near a box.
std::vector<NearParticle> particles_near(const Ground& ground, const mesh::Rectangle& box,
                                         std::size_t number) {
  std::vector<NearParticle> near;
  for (std::size_t s = ground.soil_sets; s < ground.sets.size(); ++s)
    if (const Particles& p = ground.sets[s]; p.body == number)
      for (std::size_t k = 0; k < p.size(); ++k)
        if (lies_in(box, p, k))
          near.push_back({static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(k)});
  return near;
}

} // namespace

/// The counterpart that a body meets: its position and its kind.
struct ContactNodes::Meeting {
  const BodySurface& surface;
  const Structure& structure;
  const BodyLattice* own;      ///< lattice of the body; null: it is rigid
  const OtherStructure* other; ///< null: the soil
  const BodySurface* surface_of_other;
  const Lattice& lattice; ///< of what it meets
  int column;             ///< of its first node, among the nodes of the soil's finest lattice
  int row;
  std::span<const NearParticle> near;
  bool bonded;
};

std::vector<NearParticle> particles_near(const Ground& ground, mesh::Rectangle box, double margin) {
  std::vector<NearParticle> near;
  box = widened(box, margin);
  for (std::size_t s = 0; s < ground.soil_sets; ++s) {
    const Particles& p = ground.sets[s];
    for (std::size_t block = 0; block + 1 < p.block_start.size(); ++block) {
      if (p.block_start[block] == p.block_start[block + 1] ||
          !ground.tiles.reaches(block % ground.tiles.count(), box))
        continue;
      for (std::size_t k = p.block_start[block]; k < p.block_start[block + 1]; ++k)
        if (lies_in(box, p, k))
          near.push_back({static_cast<std::uint32_t>(s), static_cast<std::uint32_t>(k)});
    }
  }
  return near;
}

PushedOut push_out(Ground& ground, const BodySurface& surface, std::span<const NearParticle> near) {
  const mesh::Rectangle box = surface.bounds();
  PushedOut pushed;
  for (const auto& [set, k] : near) {
    Particles& p = ground.sets[set];
    if (p.x[k] < box.x_min || p.x[k] > box.x_max || p.y[k] < box.y_min || p.y[k] > box.y_max)
      continue;
    if (!surface.contains({p.x[k], p.y[k]})) // which costs a third of what the nearest place does
      continue;
    const BodySurface::Nearest nearest = surface.nearest({p.x[k], p.y[k]});
    const double out = -nearest.distance - 0.5 * p.half_size;
    if (out <= 0.0)
      continue;
    p.x[k] += out * nearest.normal.x;
    p.y[k] += out * nearest.normal.y;
    pushed.farthest = std::max(pushed.farthest, out);
    ++pushed.count;
  }
  return pushed;
}

void ContactNodes::follow_sort(const Ground& ground, const BodySurface& surface, double margin) {
  near_ = particles_near(ground, surface.bounds(), margin);
  const double way = 2.0 * ground.sort_distance(); // of a particle and the body towards each other
  may_enter_.clear();
  std::ranges::copy_if(near_, std::back_inserter(may_enter_), [&](const NearParticle& of) {
    const Particles& p = ground.sets[of.set];
    return surface.nearest({p.x[of.index], p.y[of.index]}).distance <= way;
  });
  for (OtherStructure& other : others_)
    other.near = particles_near(ground, widened(surface.bounds(), margin), other.number);
}

void ContactNodes::find_reach(const Ground& ground, const Meeting& meeting) {
  const Lattice& lattice = meeting.lattice;
  const double empty = empty_mass(ground);
  reach_.assign(window_.count(), Reach::none);
  firsts_ = {window_.i0 - 3, window_.j0 - 3, window_.columns + 3, window_.rows + 3};
  reaches_.assign(firsts_.count(), 0);
  for (int j = window_.j0; j < window_.j0 + window_.rows; ++j)
    for (int i = window_.i0; i < window_.i0 + window_.columns; ++i) {
      const std::size_t position = window_.index(i, j);
      if (ground.grid.mass[lattice.index(i, j)] <= empty)
        continue;
      if (wall_[position] > least_wall_share * lattice.h ||
          meeting.surface.contains({lattice.x0 + i * lattice.h, lattice.y0 + j * lattice.h}))
        reach_[position] = Reach::whole;
      else if (meeting.own != nullptr)
        reach_[position] = Reach::faint;
      if (reach_[position] == Reach::none)
        continue;
      for (int b = 0; b < 4; ++b)
        for (int a = 0; a < 4; ++a)
          reaches_[firsts_.index(i - a, j - b)] = 1;
    }
}

void ContactNodes::weigh_particles(Ground& ground, const Meeting& meeting) {
  const std::span<const NearParticle> near = meeting.near;
  const Lattice& lattice = meeting.lattice;
  const Axis x_axis(lattice.x0, lattice.h);
  const Axis y_axis(lattice.y0, lattice.h);
  const mesh::Rectangle reached = widened(meeting.surface.bounds(), 2.0 * ground.finest_lattice().h);
  constexpr std::size_t part = 128;
  touches_.assign(near.size(), {});
  entries_.resize((near.size() + part - 1) / part);
  ground.workers.run(entries_.size(), [&](std::size_t task) {
    std::vector<Entry>& entries = entries_[task];
    entries.clear();
    for (std::size_t n = task * part; n < std::min(near.size(), (task + 1) * part); ++n) {
      const Particles& p = ground.sets[near[n].set];
      const std::size_t k = near[n].index;
      const int column = static_cast<int>(std::floor(x_axis.cells(p.x[k]))) - 1;
      const int row = static_cast<int>(std::floor(y_axis.cells(p.y[k]))) - 1;
      if (!firsts_.has(column, row) || reaches_[firsts_.index(column, row)] == 0)
        continue;
      const double l = std::min(p.half_size, lattice.h);
      const Weights wx = cell_weights(p.x[k], x_axis, l);
      const Weights wy = cell_weights(p.y[k], y_axis, l);
      const std::size_t before = entries.size();
      for (std::size_t b = 0; b < 4; ++b)
        for (std::size_t a = 0; a < 4; ++a) {
          const int i = wx.base + static_cast<int>(a);
          const int j = wy.base + static_cast<int>(b);
          if (!window_.has(i, j) || reach_[window_.index(i, j)] == Reach::none)
            continue;
          const double vs = p.volume[k] * wx.s[a] * wy.s[b];
          if (vs > 0.0)
            entries.push_back({n,
                               window_.index(i, j),
                               vs,
                               {p.volume[k] * wx.g[a] * wy.s[b], p.volume[k] * wx.s[a] * wy.g[b]}});
        }
      if (entries.size() > before && lies_in(reached, p, k))
        touches_[n] = touch(meeting, p, k);
    }
  });
}

ContactNodes::Touch ContactNodes::touch(const Meeting& meeting, const Particles& p, std::size_t k) {
  const Vector position{p.x[k], p.y[k]};
  const BodySurface::Nearest nearest = meeting.surface.nearest(position);
  double reaches =
      nearest.corner ? p.half_size : p.half_size * (std::abs(nearest.normal.x) + std::abs(nearest.normal.y));
  if (meeting.surface_of_other != nullptr)
    reaches = std::min(reaches, std::max(0.0, -meeting.surface_of_other->nearest(position).distance));
  return {nearest.distance - reaches, nearest.corner, {-nearest.normal.x, -nearest.normal.y}};
}

void ContactNodes::sum_particles(const Ground& ground, const Meeting& meeting) {
  const Structure& structure = meeting.structure;
  sums_.assign(window_.count(), {});
  const auto entries = std::views::join(entries_);
  for (const Entry& entry : entries)
    sums_[entry.position].least_gap = std::min(sums_[entry.position].least_gap, touches_[entry.near].gap);
  for (const auto& [n, position, vs, gradient] : entries) {
    const Particles& p = ground.sets[meeting.near[n].set];
    const std::size_t k = meeting.near[n].index;
    Sums& sums = sums_[position];
    sums.gradient += gradient;
    sums.volume += vs;
    sums.friction += vs * (meeting.other ? meeting.other->friction : structure.friction[p.soil_index]);
    sums.adhesion += meeting.other ? 0.0 : vs * structure.adhesion[p.soil_index];
    if (const Touch& touch = touches_[n]; std::isfinite(touch.gap) && !touch.corner &&
                                          touch.gap <= sums.least_gap + surface_layer * 2.0 * p.half_size) {
      sums.surface += vs;
      sums.gap += vs * touch.gap;
      sums.facing += vs * touch.normal;
    }
    if (!p.traits.wet)
      continue;
    sums.wet += vs;
    sums.suction += vs * (p.water->fluid.cavitation_pressure - rest_pressure(p, k));
    if (p.traits.flowing)
      continue;
    const double excess = excess_pressure(p, k);
    sums.sealed += vs;
    sums.sealed_force += excess * gradient;
  }
}

void ContactNodes::find(Ground& ground, const BodySurface& surface, const Vector& centre,
                        const Structure& structure, const BodyLattice* own, bool bonded,
                        std::span<const BodySurface* const> surfaces) {
  const std::vector<ContactNode> before = std::move(nodes_);
  nodes_.clear();
  of_nodes_.clear();
  find_nodes(ground,
             {surface, structure, own, nullptr, nullptr, ground.finest_lattice(), 0, 0, near_, bonded},
             before);
  for (const OtherStructure& other : others_)
    if (!other.near.empty()) {
      const BodyLattice& its = ground.bodies[other.number];
      find_nodes(ground,
                 {surface, structure, own, &other, surfaces[other.structure], its.lattice, its.column,
                  its.row, other.near, bonded},
                 before);
    }
  placed_ = true;
  for (ContactNode& c : nodes_)
    c.arm = c.position - centre;
  if (own == nullptr)
    bear_on(surface, centre, ground.finest_lattice().h);
}

void ContactNodes::find_nodes(Ground& ground, const Meeting& meeting, std::span<const ContactNode> before) {
  const auto& [surface, structure, own, other, its_surface, lattice, column, row, near, bonded] = meeting;
  const Grid& grid = ground.grid;
  window_ = nodes_around(lattice, surface.bounds());
  find_wall(surface, lattice, window_, wall_);
  find_reach(ground, meeting);
  weigh_particles(ground, meeting);
  sum_particles(ground, meeting);
  const double empty = empty_mass(ground);
  const ContactGaps& gaps = ground.spec.gaps;
  auto known = before.begin();
  for (int j = window_.j0; j < window_.j0 + window_.rows; ++j)
    for (int i = window_.i0; i < window_.i0 + window_.columns; ++i) {
      const std::size_t in_window = window_.index(i, j);
      const Sums& sums = sums_[in_window];
      if (sums.volume <= 0.0)
        continue;
      const std::size_t node = lattice.index(i, j);
      const Vector position{lattice.x0 + i * lattice.h, lattice.y0 + j * lattice.h};
      const bool at_edge = sums.surface > 0.0;
      const bool faint = reach_[in_window] == Reach::faint;
      if (faint && !at_edge)
        continue;
      const bool of_soil = length(sums.gradient) > 0.0;
      if (!at_edge && !of_soil)
        continue;
      const std::optional<std::size_t> body_node =
          own != nullptr ? own->node_at(column + i, row + j) : std::nullopt;
      if (own != nullptr && !(body_node && grid.mass[*body_node] > empty))
        continue;
      // The search for the sets begins with those of the last step.
      const NodeKey key{other ? std::optional(other->structure) : std::nullopt, row + j, column + i};
      while (known != before.end() && known->key < key)
        ++known;
      ContactNode& found = nodes_.emplace_back();
      bool was_tied = !placed_; // structures are wished in place
      if (known != before.end() && known->key == key) {
        found.tied = known->tied;
        found.slip = known->slip;
        was_tied = known->tied;
      }
      found.key = key;
      found.node = node;
      found.position = position;
      if (body_node) {
        found.body_node = *body_node;
        found.body_mass = grid.mass[*body_node];
        found.faint = faint;
      }
      const bool by_gradient = ground.spec.normals == ContactNormals::gradient ||
                               (ground.spec.normals == ContactNormals::automatic && sums.wet > 0.0);
      found.normal = unit(at_edge ? sums.facing : sums.gradient);
      if (by_gradient && of_soil && dot(found.normal, unit(sums.gradient)) > far_apart)
        found.normal = unit(sums.gradient);
      found.area = std::max(0.0, dot(found.normal, sums.gradient));
      found.friction = sums.friction / sums.volume;
      found.gap = at_edge ? sums.gap / sums.surface : sums.least_gap;
      const double opening = bonded || sums.wet > 0.0 ? gaps.opening : gaps.opening_dry;
      found.closed = found.gap <= (was_tied ? opening : gaps.closing) * lattice.h;
      of_nodes_.push_back(sums);
    }
}

void ContactNode::set_trial(const ChangeByOthers& others) {
  const Vector solid = solid_trial + others.solid;
  const Vector water = water_trial + others.water;
  body_velocity = body_trial + others.body;
  solid_normal = dot(normal, solid);
  water_normal = dot(normal, water);
  normal_speed = (solid_mass * solid_normal + water_mass * water_normal) / mass;
  slip_speed = dot(tangent(), solid);
  water_impulse = free_impulse + full_water * dot(normal, water_mass > 0.0 ? others.water : others.solid);
}

void ContactNode::solve_alone(bool bonded) {
  const double wall = dot(normal, body_velocity);
  const double closing = normal_speed - wall;
  const double sliding = slip_speed - dot(tangent(), body_velocity);
  const double push = mass * body_mass / (mass + body_mass) * closing;
  const double water = water_impulse - full_water * (wall + push / body_mass);
  tied = closed && (bonded || push > 0.0 || (wet() && water > least_water));
  slip = 0;
  normal_impulse = effective_impulse = tangential_impulse = 0.0;
  if (tied) {
    normal_impulse = push;
    effective_impulse = push - water;
    const double stick = tangential * body_mass / (tangential + body_mass) * sliding;
    const double limit = bound(effective_impulse);
    if (!bonded && std::abs(stick) > limit)
      slip = stick > 0.0 ? 1 : -1;
    tangential_impulse = slip == 0 ? stick : slip * limit;
  }
  find_changes();
}

void ContactNode::find_changes() {
  solid_change = water_change = body_change = {};
  if (!tied)
    return;
  const Vector t = tangent();
  const double common = normal_speed - normal_impulse / mass; // along n, of grains and water
  const double along = -tangential_impulse / tangential;
  const double drift = tangential_impulse / solid_mass / drag;
  const double solid_n = common - solid_normal;
  const double water_n = common - water_normal;
  solid_change = {solid_n * normal.x + along * t.x, solid_n * normal.y + along * t.y};
  water_change = {water_n * normal.x + (along + drift) * t.x, water_n * normal.y + (along + drift) * t.y};
  if (body_mass > 0.0)
    body_change = {(normal_impulse * normal.x + tangential_impulse * t.x) / body_mass,
                   (normal_impulse * normal.y + tangential_impulse * t.y) / body_mass};
}

void ContactNodes::end_bonds(const ContactGaps& gaps, double h) {
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    if (of_nodes_[n].wet <= 0.0 && nodes_[n].gap > gaps.opening_dry * h)
      nodes_[n].closed = nodes_[n].tied = false;
}

void ContactNodes::take_trial(const Ground& ground, double dt) {
  const Grid& grid = ground.grid;
  const double water_density = ground.spec.water ? ground.spec.water->fluid.density : 0.0;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    ContactNode& c = nodes_[n];
    const Sums& sums = of_nodes_[n];
    c.solid_mass = grid.mass[c.node];
    c.solid_before = grid.velocity_before(c.node);
    c.solid_trial = grid.velocity_after(c.node);
    if (c.body_mass > 0.0) {
      c.body_before = grid.velocity_before(c.body_node);
      c.body_trial = grid.velocity_after(c.body_node);
    }
    c.water_mass = 0.0;
    c.water_before = c.solid_before;
    c.water_trial = c.solid_trial;
    c.drag = 1.0;
    c.full_water = water_density * sums.sealed;
    c.free_impulse = c.full_water * dot(c.normal, c.solid_before) + dt * dot(c.normal, sums.sealed_force);
    if (ground.has_flow() && grid.water_mass[c.node] > 1e-9 * c.solid_mass) {
      const double full = water_density * grid.wet_volume[c.node];
      c.water_mass = grid.water_mass[c.node];
      c.water_before = {grid.wx_before[c.node], grid.wy_before[c.node]};
      c.water_trial = {grid.wx_after[c.node], grid.wy_after[c.node]};
      c.full_water += full;
      // Water at a wall has the wall's normal velocity, but reads some of its neighbourhood's flow from the
      // particles: this is stopped anew in every step, and no stress between grains.
      const Vector flow = c.water_before - c.solid_before;
      c.free_impulse += full * dot(c.normal, c.solid_before) + c.water_mass * dot(c.normal, flow) +
                        dt * dot(c.normal, {grid.water_force_x[c.node], grid.water_force_y[c.node]});
      const double ratio = c.water_mass / c.solid_mass;
      c.drag += dt * (1.0 + ratio) * c.water_mass / (full * full) * grid.resistance[c.node];
    }
    c.mass = c.solid_mass + c.water_mass;
    c.tangential = c.mass / (1.0 + c.water_mass / c.solid_mass / c.drag);
    c.least_water = sums.wet > 0.0 ? sums.suction / sums.wet * c.area * dt : 0.0;
    c.adhesion = sums.adhesion / sums.volume * c.area * dt;
    c.set_trial({});
  }
}

void ContactNodes::take_relaxing(const Ground& ground, double dt) {
  const Grid& grid = ground.grid;
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    ContactNode& c = nodes_[n];
    c.mass = c.tangential = c.solid_mass = grid.mass[c.node];
    c.solid_trial = c.water_trial = grid.velocity_after(c.node);
    if (c.body_mass > 0.0)
      c.body_trial = grid.velocity_after(c.body_node);
    c.adhesion = of_nodes_[n].adhesion / of_nodes_[n].volume * c.area * dt;
    c.set_trial({});
  }
}

} // namespace tremolo::mpm_domain
