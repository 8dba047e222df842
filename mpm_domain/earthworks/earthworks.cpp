#include "mpm_domain/earthworks/earthworks.hpp"

#include "mesh/polygon.hpp"
#include "mpm_domain/earthworks/placing.hpp"
#include "mpm_domain/particles/change_of_set.hpp"
#include "mpm_domain/ranks/lists_of_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

bool is_same(const Region& a, const Region& b) {
  return a.soil == b.soil && std::ranges::equal(a.polygon, b.polygon, [](const Vector& p, const Vector& q) {
           return p.x == q.x && p.y == q.y;
         });
}

/// The first earthwork from one on that removes a region; their number: none does.
std::size_t removal_of(const Region& region, const std::vector<Earthwork>& all, std::size_t from) {
  while (from < all.size() &&
         std::ranges::none_of(all[from].remove, [&](const Region& other) { return is_same(other, region); }))
    ++from;
  return from;
}

/// A particle in a region.
struct InRegion {
  std::size_t set;
  std::uint32_t id;
  Vector position; ///< m
};

/// Finds the particles of all ranks in a region, in the order in which one process finds them.
std::vector<InRegion> particles_in(const Region& region, const Ground& ground) {
  std::vector<InRegion> found;
  for (std::size_t s = 0; s < ground.soil_sets; ++s) {
    const Particles& set = ground.sets[s];
    for (std::size_t k = 0; k < set.size(); ++k)
      if (mesh::inside(region.polygon, set.x[k], set.y[k]))
        found.push_back({s, set.id[k], {set.x[k], set.y[k]}});
  }
  if (ground.share) {
    found = lists_of_all(*ground.ranks(), found);
    std::ranges::stable_sort(found, {}, &InRegion::set);
  }
  return found;
}

} // namespace

Earthworks::Earthworks(Ground& ground) : going_(ground.spec.earthworks.size()) {
  if (!any())
    return;
  const std::vector<Earthwork>& all = ground.spec.earthworks;
  for (const Earthwork& work : all)
    for (const Region& region : work.place)
      soil_to_place(ground, region); // refuses what could not be placed, before the ground is shaken
  for (const Region& region : ground.spec.regions) {
    const std::size_t removal = removal_of(region, all, 0);
    if (removal == all.size())
      continue;
    for (const auto& [set, id, position] : particles_in(region, ground)) {
      if (ground.sets[set].water)
        throw std::invalid_argument(
            fmt::format("soil that is removed while the ground is in motion lies below the water at x = "
                        "{:.6g} m, y = {:.6g} m; allowed: above it",
                        position.x, position.y));
      add_going(ground, removal, set, id);
    }
  }
}

void Earthworks::begin(Ground& ground, const std::function<void()>& order) {
  order();
  const auto before = node_loads(ground);
  remove(ground);
  place(ground);
  order();
  held_ = HeldForces(before, node_loads(ground), ground.ranks());
  ++begun_;
}

double Earthworks::share_held(const Ground& ground, double time) const {
  return begun_ == 0 ? 0.0 : 1.0 - ground.spec.earthworks[begun_ - 1].growth.share(time);
}

void Earthworks::add_going(Ground& ground, std::size_t earthwork, std::size_t set, std::uint32_t id) {
  keep_whole(ground, set, id);
  going_[earthwork].push_back({set, id});
}

void Earthworks::remove(Ground& ground) {
  std::vector<std::vector<std::size_t>> gone(ground.soil_sets);
  for (const auto& [s, id] : going_[begun_])
    if (const std::size_t k = ground.sets[s].index_of[id]; k != Particles::nowhere)
      gone[s].push_back(k);
  for (std::size_t s = 0; s < gone.size(); ++s) {
    std::ranges::sort(gone[s]);
    if (!gone[s].empty())
      mpm_domain::remove(ground.sets[s], gone[s]);
  }
}

/// All ranks know what is placed, and the first one takes it, until the next sort.
void Earthworks::place(Ground& ground) {
  const std::vector<Earthwork>& all = ground.spec.earthworks;
  std::vector<std::pair<std::vector<Particles>, const Region*>> coming; // none settles on another one
  for (const Region& region : all[begun_].place)
    coming.emplace_back(soil_to_place(ground, region), &region);
  for (const auto& [sets, region] : coming)
    for (std::size_t s = 0; s < sets.size(); ++s)
      for (std::size_t k = 0; k < sets[s].size(); ++k) {
        Particles& set = ground.sets[s];
        const std::size_t id = set.index_of.size();
        if (ground.has_structures_here())
          add_copy(sets[s], k, set);
        else
          set.index_of.give(id + 1);
        if (const std::size_t removal = removal_of(*region, all, begun_ + 1); removal < all.size())
          add_going(ground, removal, s, static_cast<std::uint32_t>(id));
      }
}

std::vector<Pass> earthwork_passes(Ground& ground, const Earthworks& earthworks) {
  if (!earthworks.any())
    return {};
  const auto share = [&](const Step& step) { return earthworks.share_held(ground, step.time); };
  std::vector<Pass> passes{{Phase::forces, "earthworks",
                            [&, share](Step& step) {
                              if (const double held = share(step); held > 0.0)
                                earthworks.held().act(ground, held);
                            }},
                           {Phase::books, "", [&, share](Step& step) {
                              if (const double held = share(step); held > 0.0) {
                                step.bookings.add(
                                    earthworks.held().power(ground, held),
                                    [&energy = step.energy, kick = step.kicks.front()](const auto& power) {
                                      energy.static_ += kick * power[0];
                                    });
                              }
                            }}};
  if (ground.is_remapped())
    passes.push_back({Phase::remap, "", [&, share](Step& step) {
                        if (const double held = share(step); held > 0.0)
                          step.remap_power[0][0] += earthworks.held().remap_power(ground, held)[0];
                      }});
  return passes;
}

} // namespace tremolo::mpm_domain
