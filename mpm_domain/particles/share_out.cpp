#include "mpm_domain/particles/share_out.hpp"

#include "mpm_domain/particles/journey.hpp"
#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// The tiles that hold nodes of periodic sides, images and what they are images of, by row of tiles. A rank
/// that has one tile of a row has them all, so that sums at both sides come together.
std::vector<std::vector<std::size_t>> tiles_of_images(const Ground& ground) {
  const Grid& grid = ground.grid;
  if (ground.mesh)
    return {}; // whose images are ties
  std::vector<bool> is_linked(static_cast<std::size_t>(grid.nx), false);
  for (int i = 0; i < grid.nx; ++i)
    if (const int real = grid.real_column(i); real != i)
      is_linked[static_cast<std::size_t>(i)] = is_linked[static_cast<std::size_t>(real)] = true;
  std::map<int, std::vector<std::size_t>> rows;
  for (std::size_t tile = 0; tile < ground.tiles.first(1); ++tile) {
    const NodeBlock nodes = overlap(ground.tiles.window(tile), {0, 0, grid.nx, grid.ny});
    const auto first = is_linked.begin() + nodes.column;
    if (std::find(first, first + nodes.columns, true) != first + nodes.columns)
      rows[nodes.row].push_back(tile);
  }
  std::vector<std::vector<std::size_t>> groups;
  for (auto& [row, tiles] : rows)
    groups.push_back(std::move(tiles));
  return groups;
}

/// Updates of particles in the tiles in a step of clock 0, over all ranks; then their load.
struct Census {
  std::vector<std::int64_t> on_lattice; ///< by tile: those that touch one lattice
  std::vector<std::int64_t> across;     ///< by tile: all others

  explicit Census(const Ground& ground)
      : on_lattice(ground.tiles.count(), 0), across(ground.tiles.count(), 0) {}
  std::int64_t all_across() const { return std::reduce(across.begin(), across.end()); }
  std::vector<std::int64_t> of_tiles() const {
    std::vector<std::int64_t> sums = on_lattice;
    for (std::size_t tile = 0; tile < sums.size(); ++tile)
      sums[tile] += across[tile];
    return sums;
  }
};

/// Processor time that an update takes besides gather and law, ns (docs/performance.md).
constexpr double other_passes = 40.0;

/// The load of updates: the time that they take, by what those of the same tile took since the last deal, ns.
/// The census of a share that has not stepped yet, or whose tiles are others now, counts all alike.
void weigh_by_time(const RankShare& share, Census& census) {
  const std::size_t tiles = census.on_lattice.size();
  std::vector<double> cost(tiles, other_passes);
  if (share.times.steps() > 0 && share.times.nanoseconds().size() == tiles) {
    std::vector<std::int64_t> time(share.times.nanoseconds().begin(), share.times.nanoseconds().end());
    share.ranks->add(time);
    for (std::size_t tile = 0; tile < tiles; ++tile)
      if (share.updates[tile] > 0)
        cost[tile] +=
            static_cast<double>(time[tile]) / static_cast<double>(share.times.steps() * share.updates[tile]);
  }
  for (std::vector<std::int64_t>* const updates : {&census.on_lattice, &census.across})
    for (std::size_t tile = 0; tile < tiles; ++tile)
      (*updates)[tile] = std::llround(cost[tile] * static_cast<double>((*updates)[tile]));
}

/// Boxes around nodes that a graded mesh ties, and those that they follow: as far as particles across
/// lattices may touch nodes, and where levels have clocks of their own, particles of two clocks.
std::vector<mesh::Rectangle> boxes_of_ties(const Ground& ground) {
  std::vector<mesh::Rectangle> boxes;
  if (!ground.mesh)
    return boxes;
  const auto add = [&](std::size_t node) {
    const NodePosition position = ground.position_of(node);
    // Two cells of the coarser lattice, or four; the next two may run on the clock of the finer one, and
    // share nodes with two more.
    const double cells = ground.clocks.count() == 1 ? 4.0 : 8.0;
    const double reach = cells * ground.lattice(position.level).h;
    boxes.push_back(
        {position.at.x - reach, position.at.y - reach, position.at.x + reach, position.at.y + reach});
  };
  const Prolongation& ties = ground.ties();
  for (std::size_t row = 0; row < ties.tied_count(); ++row) {
    add(ties.tied(row));
    for (const Share& share : ties.row(row))
      add(share.node);
  }
  return boxes;
}

/// Groups of tiles that must share a rank. The first rank owns those near structures (in these boxes), those
/// at the joints of levels, and those of elastic bodies.
Together tiles_together(const Ground& ground, std::span<const mesh::Rectangle> structures,
                        const Census& census) {
  const TileMap& tiles = ground.tiles;
  std::vector<bool> is_of_first(tiles.count(), false);
  const auto take = [&](const std::vector<std::size_t>& some) {
    for (const std::size_t tile : some)
      is_of_first[tile] = true;
  };
  std::vector<mesh::Rectangle> boxes = boxes_of_ties(ground);
  boxes.insert(boxes.end(), structures.begin(), structures.end());
  for (const mesh::Rectangle& box : boxes)
    for (int level = 0; level < ground.soil_lattice_count(); ++level)
      take(tiles.reaching(level, box));
  for (std::size_t tile = 0; tile < tiles.count(); ++tile)
    if (census.across[tile] > 0)
      take(tiles.around(tile)); // a large particle that lies in small cells all around
    else if (tiles.level_of(tile) >= ground.soil_lattice_count())
      is_of_first[tile] = true;

  Together together;
  together.besides = census.all_across();
  for (std::vector<std::size_t>& group : tiles_of_images(ground))
    if (std::ranges::any_of(group, [&](std::size_t tile) { return is_of_first[tile]; }))
      take(group);
    else
      together.groups.push_back(std::move(group));
  for (std::size_t tile = 0; tile < tiles.count(); ++tile)
    if (is_of_first[tile])
      together.of_first.push_back(tile);
  return together;
}

std::size_t all_blocks(const Ground& ground) {
  return ground.block_count() + ground.across_block_count();
}

/// Counts the updates of the particles in the blocks of the sets.
Census census_of_blocks(const Ground& ground) {
  Census census(ground);
  for (const Particles& set : ground.sets)
    for (std::size_t block = 0; block + 1 < set.block_start.size(); ++block)
      (block < ground.block_count() ? census.on_lattice : census.across)[block % ground.tiles.count()] +=
          static_cast<std::int64_t>(set.block_start[block + 1] - set.block_start[block])
          << ground.clock_of_block(block);
  return census;
}

/// A deal, and the updates that go with it in a RankShare.
struct Dealt {
  Deal deal;
  std::vector<std::int64_t> updates;
};

/// The deal that comes after the present one.
/// @param own   of this rank's particles
/// @param find  follow() or improved()
Dealt next_deal(const Ground& ground, Census own, decltype(follow) find) {
  const RankShare& share = *ground.share;
  share.ranks->add(own.on_lattice);
  if (ground.mesh)
    share.ranks->add(own.across);
  std::vector<std::int64_t> updates = own.of_tiles();
  weigh_by_time(share, own);
  const Together together = tiles_together(ground, share.structures, own);
  return {find(share.deal, ground.tiles, std::move(own.on_lattice), share.ranks->size(), together),
          std::move(updates)};
}

void take(Ground& ground, Dealt dealt) {
  RankShare& share = *ground.share;
  share.deal = std::move(dealt.deal);
  share.updates = std::move(dealt.updates);
  share.times.restart(ground.tiles.count());
}

/// Sends the particles of a set to the ranks of their tiles.
/// @param tile_of  (particle) its tile; particles come in their order
template <typename TileOf>
Journey to_owners(const RankShare& share, const Particles& set, TileOf tile_of) {
  Journey journey(*share.ranks, set);
  for (std::size_t k = 0; k < set.size(); ++k)
    if (const std::size_t tile = tile_of(k); share.is_mine(tile))
      journey.stay(k);
    else
      journey.go(k, share.owner(tile));
  return journey;
}

} // namespace

void deal_out_blocks(Ground& ground, Communicator& ranks, std::vector<mesh::Rectangle> structures) {
  Census census = census_of_blocks(ground);
  RankShare& share =
      ground.share.emplace(RankShare{.ranks = &ranks, .deal = {}, .updates = census.of_tiles()});
  share.times.restart(ground.tiles.count());
  weigh_by_time(share, census);
  const Together together = tiles_together(ground, structures, census);
  share.deal = deal_out(ground.tiles, std::move(census.on_lattice), ranks.size(), together);
  share.structures = std::move(structures);
}

void move_between_ranks(Ground& ground) {
  RankShare& share = *ground.share;
  Census census(ground);
  std::vector<std::vector<std::size_t>> tile_of_particle;
  for (const Particles& set : ground.sets) {
    std::vector<std::size_t>& tile = tile_of_particle.emplace_back(set.size());
    const int level = set.body ? ground.soil_lattice_count() + static_cast<int>(*set.body) : 0;
    for (std::size_t k = 0; k < set.size(); ++k) {
      const LatticeOfParticle of = ground.mesh && !set.body
                                       ? lattice_of(set, k, *ground.mesh, ground.sort_distance())
                                       : LatticeOfParticle{level, true};
      tile[k] = tile_of(set, k, ground.tiles, of.level);
      (of.alone ? census.on_lattice : census.across)[tile[k]] += std::int64_t{1}
                                                                 << ground.clocks.at(set.x[k], set.y[k]);
    }
  }
  take(ground, next_deal(ground, std::move(census), follow));
  for (std::size_t s = 0; s < ground.sets.size(); ++s) {
    Particles& set = ground.sets[s];
    Journey journey = to_owners(share, set, [&](std::size_t k) { return tile_of_particle[s][k]; });
    if (journey.count() > 0)
      journey.arrive(set, set.block_start.size());
  }
}

bool deal_anew(Ground& ground) {
  Dealt dealt = next_deal(ground, census_of_blocks(ground), improved);
  if (dealt.deal.owner == ground.share->deal.owner)
    return false;
  take(ground, std::move(dealt));
  for (Particles& set : ground.sets) {
    std::size_t block = 0;
    Journey journey = to_owners(*ground.share, set, [&](std::size_t k) {
      while (k >= set.block_start[block + 1])
        ++block;
      return block % ground.tiles.count();
    });
    journey.arrive(set, all_blocks(ground));
  }
  resize_fields(ground.grid, ground.grid.size());
  return true;
}

GatheredSets gather_sets(const Ground& ground, const Wanted& wanted, std::size_t more,
                         const AddNumbers& add_numbers) {
  GatheredSets gathered;
  for (std::size_t s = 0; s < ground.sets.size(); ++s) {
    const Particles& set = ground.sets[s];
    Journey journey(*ground.share->ranks, set);
    for (std::size_t k = 0; k < set.size(); ++k)
      if (wanted(s, k))
        journey.go(k, 0);
    Particles copy = empty_like(set);
    const auto add = [&](std::size_t k, std::vector<double>& to) { add_numbers(s, k, to); };
    gathered.numbers.push_back(journey.arrive(copy, all_blocks(ground), {more, add}));
    gathered.sets.push_back(std::move(copy));
  }
  if (ground.share->ranks->rank() != 0)
    return {};
  return gathered;
}

} // namespace tremolo::mpm_domain
