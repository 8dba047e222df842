#include "mpm_domain/earthworks/placing.hpp"

#include "mesh/polygon.hpp"
#include "mpm_domain/particles/bounds.hpp"
#include "mpm_domain/particles/change_of_set.hpp"
#include "mpm_domain/particles/fill/fill.hpp"
#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "mpm_domain/ranks/lists_of_all.hpp"
#include "mpm_domain/tiles/totals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>

namespace tremolo::mpm_domain {

namespace {

/// Boxes of particles, found by the squares that they reach into.
class Occupied {
public:
  explicit Occupied(double square) : square_(square) {}

  void add(const mesh::Rectangle& box) {
    for (std::int64_t i = along(box.x_min); i <= along(box.x_max); ++i)
      for (std::int64_t j = along(box.y_min); j <= along(box.y_max); ++j)
        boxes_[key(i, j)].push_back(box);
  }
  bool at(Vector point) const {
    const auto found = boxes_.find(key(along(point.x), along(point.y)));
    return found != boxes_.end() && std::ranges::any_of(found->second, [&](const mesh::Rectangle& box) {
             return point.x >= box.x_min && point.x <= box.x_max && point.y >= box.y_min &&
                    point.y <= box.y_max;
           });
  }

private:
  std::int64_t along(double position) const {
    return static_cast<std::int64_t>(std::floor(position / square_));
  }
  static std::int64_t key(std::int64_t i, std::int64_t j) { return (i << 32) + j; }

  double square_;
  std::unordered_map<std::int64_t, std::vector<mesh::Rectangle>> boxes_;
};

/// Finds where particles of any rank touch a box.
Occupied positions_in(const mesh::Rectangle& around, const Ground& ground) {
  std::vector<mesh::Rectangle> boxes;
  for (const Particles& set : ground.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      if (const mesh::Rectangle box = box_of(set, k); box.x_max >= around.x_min &&
                                                      box.x_min <= around.x_max &&
                                                      box.y_max >= around.y_min && box.y_min <= around.y_max)
        boxes.push_back(box);
  if (ground.share)
    boxes = lists_of_all(*ground.share->ranks, boxes);
  Occupied occupied(ground.lattice(0).h);
  for (const mesh::Rectangle& box : boxes)
    occupied.add(box);
  return occupied;
}

/// Makes a box around regions and a strip beside them, m.
mesh::Rectangle box_around(const std::vector<Region>& regions, double more) {
  mesh::Rectangle box = around_nothing;
  for (const Region& region : regions)
    for (const Vector& corner : region.polygon)
      reach_around(box, corner.x, corner.y);
  return {box.x_min - more, box.y_min - more, box.x_max + more, box.y_max + more};
}

/// Largest settlement of the soil on any rank, m.
double largest_settlement(const Ground& ground) {
  double largest = 0.0;
  for (const Particles& set : ground.sets_of_soil())
    for (std::size_t k = 0; k < set.size(); ++k)
      largest = std::max(largest, set.y_initial[k] - set.y[k]);
  take_largest(ground, {&largest, 1});
  return largest;
}

/// The region, drawn over copies of itself that reach down to where the ground may be.
std::vector<Region> drawn_down(const Region& region, double depth, double step) {
  std::vector<Region> regions;
  for (long copies = std::lround(std::ceil(depth / step)); copies > 0; --copies) {
    const double down = static_cast<double>(copies) * step;
    Region& copy = regions.emplace_back(region);
    for (Vector& corner : copy.polygon)
      corner.y -= down;
    for (double& cut : copy.cuts)
      cut -= down;
  }
  regions.push_back(region);
  return regions;
}

/// A particle of the fill.
struct Candidate {
  std::size_t set;
  std::size_t k;
};

/// The particles to be placed: those of the polygon where there is no ground, and those that fill a gap under
/// it.
std::vector<Candidate> laid(const std::vector<Particles>& fill, const Region& region, Occupied occupied) {
  std::vector<Candidate> laid;
  std::vector<Candidate> under;
  const auto position = [&](const Candidate& c) { return Vector{fill[c.set].x[c.k], fill[c.set].y[c.k]}; };
  for (std::size_t s = 0; s < fill.size(); ++s)
    for (std::size_t k = 0; k < fill[s].size(); ++k)
      if (const Vector at{fill[s].x[k], fill[s].y[k]}; !occupied.at(at))
        (mesh::inside(region.polygon, at.x, at.y) ? laid : under).push_back({s, k});
  std::ranges::sort(under, {}, [&](const Candidate& c) { return position(c).y; });
  for (const Candidate& c : under) {
    const Vector at = position(c);
    if (!occupied.at({at.x, at.y - 2.0 * fill[c.set].half_size}))
      continue; // nothing carries it
    occupied.add(box_of(fill[c.set], c.k));
    laid.push_back(c);
  }
  return laid;
}

} // namespace

std::vector<Particles> soil_to_place(const Ground& ground, const Region& region) {
  Spec spec = ground.spec;
  const double smallest = particle_size(spec, ground.mesh ? ground.mesh->tree().finest() : 0);
  spec.regions = drawn_down(region, largest_settlement(ground), smallest);
  const std::vector<Particles> all = fill(spec, ground.head, ground.mesh ? &ground.mesh->tree() : nullptr);
  const mesh::Rectangle around = box_around(spec.regions, 2.0 * particle_size(spec));
  std::vector<Candidate> kept = laid(all, region, positions_in(around, ground));
  std::ranges::sort(kept, {}, [](const Candidate& c) { return std::pair(c.set, c.k); });
  std::vector<Particles> placed;
  for (const Particles& set : all)
    placed.push_back(empty_like(set));
  for (const Candidate& c : kept) {
    if (all[c.set].water)
      throw std::invalid_argument(fmt::format("soil that is placed while the ground is in motion lies below "
                                              "the water at x = {:.6g} m, y = {:.6g} m; allowed: above it",
                                              all[c.set].x[c.k], all[c.set].y[c.k]));
    add_copy(all[c.set], c.k, placed[c.set]);
  }
  set_rest_stress(placed, spec);
  for (Particles& set : placed)
    materials::initialise(set.law, set.points(0, set.size()));
  return placed;
}

} // namespace tremolo::mpm_domain
