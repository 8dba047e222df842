#include "mpm_domain/boundary/load/surface_loads.hpp"

#include "mpm_domain/ground.hpp"
#include "mpm_domain/particles/bounds.hpp"
#include "mpm_domain/particles/fill/fill.hpp"
#include "mpm_domain/ranks/lists_of_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>

namespace tremolo::mpm_domain {

namespace {

/// A particle that has nothing above it.
struct Uppermost {
  std::size_t set;
  std::uint32_t id;
  Vector position; ///< m

  bool is_above(const Uppermost& other) const {
    return std::tuple(position.y, other.set, other.id) > std::tuple(other.position.y, set, id);
  }
};

/// The surface by columns as wide as the smallest particles, from the left.
using Surface = std::vector<std::optional<Uppermost>>;

void raise(std::optional<Uppermost>& column, const Uppermost& particle) {
  if (!column || particle.is_above(*column))
    column = particle;
}

/// Ranks take the uppermost of what each has in a column.
Surface surface_of_all(Communicator& ranks, const Surface& own) {
  struct InColumn {
    std::size_t column;
    Uppermost particle;
  };
  std::vector<InColumn> known;
  for (std::size_t c = 0; c < own.size(); ++c)
    if (own[c])
      known.push_back({c, *own[c]});
  Surface surface(own.size());
  for (const auto& [column, particle] : lists_of_all(ranks, known))
    raise(surface[column], particle);
  return surface;
}

Surface surface_of(const Ground& ground, double width) {
  const Box& box = ground.spec.box;
  Surface surface(static_cast<std::size_t>(std::lround((box.x_max - box.x_min) / width)));
  for (std::size_t s = 0; s < ground.soil_sets; ++s) {
    const Particles& set = ground.sets[s];
    const auto covers = static_cast<std::size_t>(std::lround(2.0 * set.half_size / width));
    for (std::size_t k = 0; k < set.size(); ++k) {
      const auto first =
          static_cast<std::size_t>(std::lround((set.x[k] - set.half_size - box.x_min) / width));
      for (std::size_t c = first; c < std::min(first + covers, surface.size()); ++c)
        raise(surface[c], {s, set.id[k], {set.x[k], set.y[k]}});
    }
  }
  return ground.share ? surface_of_all(*ground.share->ranks, surface) : surface;
}

/// The upper edge of a particle, and which part of it is loaded.
struct LoadedEdge {
  Vector middle;
  double half;    ///< of its length, m
  double stretch; ///< of lengths along it since the start
  double share;   ///< of its length that is loaded
};

LoadedEdge edge_of(const LoadedFace& face, const Ground& ground) {
  const Particles& set = ground.sets[face.set];
  const std::size_t k = set.index_of[face.id];
  const Vector half = half_sides(set, k);
  return {{set.x[k], set.y[k] + half.y}, half.x, half.x / set.half_size, face.half / set.half_size};
}

/// Vector from one point to another; with periodic sides, to its nearest image.
Vector way(Vector from, Vector to, const Spec& spec) {
  Vector w = to - from;
  const double period = spec.box.x_max - spec.box.x_min;
  if (spec.periodic())
    w.x -= period * std::round(w.x / period);
  return w;
}

} // namespace

SurfaceLoads::SurfaceLoads(Ground& ground) : share_(ground.spec.loads.size(), 1.0) {
  if (ground.spec.loads.empty())
    return;
  for (std::size_t load = 0; load < share_.size(); ++load)
    if (ground.spec.loads[load].growth)
      share_[load] = 0.0;
  const Box& box = ground.spec.box;
  const double width = particle_size(ground.spec, ground.mesh ? ground.mesh->tree().finest() : 0);
  const Surface surface = surface_of(ground, width);
  for (std::size_t load = 0; load < share_.size(); ++load) {
    const auto& [x_min, x_max, pressure, shear, growth] = ground.spec.loads[load];
    const Uppermost* last = nullptr;
    for (std::size_t c = 0; c < surface.size(); ++c) {
      const double left = std::max(x_min, box.x_min + static_cast<double>(c) * width);
      const double right = std::min(x_max, box.x_min + static_cast<double>(c + 1) * width);
      if (right - left < 1e-9 * width)
        continue;
      if (!surface[c])
        throw std::invalid_argument(
            fmt::format("the load from x = {:.6g} to {:.6g} m has no soil below it at x = {:.6g} m", x_min,
                        x_max, 0.5 * (left + right)));
      const auto& [s, id, position] = *surface[c];
      const double half = 0.5 * (right - left);
      if (last != nullptr && s == last->set && id == last->id) {
        faces_.back().offset += half;
        faces_.back().half += half;
      } else {
        faces_.push_back({load, s, id, left + half - position.x, half, {}, {}});
      }
      last = &*surface[c];
    }
  }
  for (const LoadedFace& face : faces_)
    keep_whole(ground, face.set, face.id);
}

void SurfaceLoads::grow(const Spec& spec, double time) {
  for (std::size_t load = 0; load < share_.size(); ++load)
    if (const auto& growth = spec.loads[load].growth)
      share_[load] = growth->share(time);
}

std::vector<mesh::Rectangle> SurfaceLoads::bounds(const Ground& ground) const {
  std::vector<mesh::Rectangle> boxes(share_.size(), around_nothing);
  for (const LoadedFace& face : faces_) {
    const Particles& set = ground.sets[face.set];
    if (const std::size_t k = set.index_of[face.id]; k != Particles::nowhere)
      reach_around(boxes[face.load], set.x[k], set.y[k]);
  }
  return boxes;
}

void SurfaceLoads::follow(const Ground& ground) {
  BoundaryFace level; // of the base: it lies along x, as the line does
  level.side = Side::base;
  for (std::size_t first = 0; first < faces_.size();) {
    const std::size_t load = faces_[first].load;
    const auto& [x_min, x_max, pressure, shear, growth] = ground.spec.loads[load];
    std::size_t end = first;
    std::vector<LoadedEdge> edges;
    for (; end < faces_.size() && faces_[end].load == load; ++end)
      edges.push_back(edge_of(faces_[end], ground));
    const std::size_t count = edges.size();
    const double covered = x_max - x_min;
    const double period = ground.spec.box.x_max - ground.spec.box.x_min;
    const bool closed = ground.spec.periodic() && covered > (1.0 - 1e-9) * period;
    // Vectors from the middle of an edge to the cut between it and the next edge, and to the next edge.
    const auto to_cut = [&](std::size_t f, std::size_t next) {
      const Vector w = way(edges[f].middle, edges[next].middle, ground.spec);
      const double part = edges[f].half / (edges[f].half + edges[next].half);
      return part * w;
    };
    for (std::size_t f = 0; f < count; ++f) {
      // The ends of the line go on as it goes before them.
      const bool is_last = f + 1 == count && !closed;
      const bool is_first = f == 0 && !closed;
      Vector ahead{edges[f].half, 0.0};
      Vector behind{-edges[f].half, 0.0};
      if (count > 1) {
        if (!is_last)
          ahead = to_cut(f, (f + 1) % count);
        if (!is_first)
          behind = to_cut(f, (f + count - 1) % count);
        if (is_last)
          ahead = -behind;
        if (is_first)
          behind = -ahead;
      }
      const auto& [middle, half, stretch, loaded] = edges[f];
      const Vector e = loaded * (ahead - behind);
      LoadedFace& face = faces_[first + f];
      face.force = {share_[load] * (pressure * e.y + shear * e.x),
                    share_[load] * (shear * e.y - pressure * e.x)};
      face_weights(ground, level, {{middle.x + stretch * face.offset, middle.y}, {stretch * face.half, 0.0}},
                   face.weights);
    }
    first = end;
  }
}

void SurfaceLoads::add(Grid& grid) const {
  for (const LoadedFace& face : faces_)
    for (const auto& [node, w] : face.weights) {
      grid.force_x[node] += w * face.force.x;
      grid.force_y[node] += w * face.force.y;
    }
}

double SurfaceLoads::power(const Grid& grid) const {
  double power = 0.0;
  for (const LoadedFace& face : faces_)
    for (const auto& [node, w] : face.weights)
      power += 0.5 * w *
               (face.force.x * (grid.vx_before[node] + grid.vx_after[node]) +
                face.force.y * (grid.vy_before[node] + grid.vy_after[node]));
  return power;
}

void SurfaceLoads::take_off_remap_power(Step& step) const {
  const Grid& grid = step.ground.grid;
  for (const LoadedFace& face : faces_)
    for (const auto& [node, w] : face.weights)
      step.remap_power[0][0].add(w * (face.force.x * (grid.vx_strain[node] - grid.vx_after[node]) +
                                      face.force.y * (grid.vy_strain[node] - grid.vy_after[node])));
}

std::vector<Pass> load_passes(Ground& ground, SurfaceLoads& loads) {
  if (!loads.any())
    return {};
  const bool is_here = ground.has_structures_here();
  std::vector<Pass> passes{{Phase::forces, "surface loads",
                            [&, is_here](Step& step) {
                              loads.grow(ground.spec, step.time);
                              if (!is_here)
                                return;
                              loads.follow(ground);
                              loads.add(ground.grid);
                            }},
                           {Phase::books, "", [&, is_here](Step& step) {
                              const double work =
                                  is_here ? step.kicks.front() * loads.power(ground.grid) : 0.0;
                              step.bookings.add(sums_of(std::array{work}),
                                                [&energy = step.energy](const std::array<double, 1>& booked) {
                                                  energy.static_ += booked[0];
                                                });
                            }}};
  if (ground.is_remapped() && is_here)
    passes.push_back({Phase::remap, "", [&](Step& step) { loads.take_off_remap_power(step); }});
  return passes;
}

} // namespace tremolo::mpm_domain
