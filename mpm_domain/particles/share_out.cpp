#include "mpm_domain/particles/share_out.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Numbers for a rank: for one set after the other the number of particles, and of each particle its block,
/// its id, its fields, its state, and what goes with it besides.
using Parcel = std::vector<double>;

constexpr int no_rank = -1;

/// Sends no additional data with the particles.
void add_nothing(std::size_t /*k*/, Parcel& /*parcel*/) {}

std::size_t numbers_per_particle(const Particles& set) {
  std::size_t fields = 0;
  set.for_fields([&](const ParticleFieldDescription&, const std::vector<double>&) { ++fields; });
  return 2 + fields + set.state_size;
}

/// Adds a set to the parcels of ranks. Quarters of particles that have been cut since the last sort stand in
/// a block behind all others.
/// @param rank_of   (particle, block) the rank that is to have it, or no_rank
/// @param add_more  (particle, parcel) adds what goes with it
template <typename RankOf, typename AddMore>
void pack(const Particles& set, const RankOf& rank_of, const AddMore& add_more,
          std::vector<Parcel>& parcels) {
  std::vector<const std::vector<double>*> fields;
  set.for_fields(
      [&](const ParticleFieldDescription&, const std::vector<double>& values) { fields.push_back(&values); });
  std::vector<std::size_t> count_at;
  for (Parcel& parcel : parcels) {
    count_at.push_back(parcel.size());
    parcel.push_back(0.0);
  }
  for (std::size_t block = 0; block < set.block_start.size(); ++block)
    for (std::size_t k = set.block_start[block];
         k < (block + 1 < set.block_start.size() ? set.block_start[block + 1] : set.size()); ++k) {
      const int to = rank_of(k, block);
      if (to == no_rank)
        continue;
      const auto rank = static_cast<std::size_t>(to);
      Parcel& parcel = parcels[rank];
      parcel[count_at[rank]] += 1.0;
      parcel.push_back(static_cast<double>(block));
      parcel.push_back(static_cast<double>(set.id[k]));
      for (const std::vector<double>* field : fields)
        parcel.push_back((*field)[k]);
      const auto state = set.state.begin() + static_cast<std::ptrdiff_t>(k * set.state_size);
      parcel.insert(parcel.end(), state, state + static_cast<std::ptrdiff_t>(set.state_size));
      add_more(k, parcel);
    }
}

/// Fills a set with its particles from parcels, by their blocks. A block's particles come from one rank.
/// @param more  how many numbers go with a particle besides
/// @param next  where the set begins in each parcel; then where it ends
/// @returns these numbers, particle after particle
std::vector<double> unpack(Particles& set, std::size_t blocks, const std::vector<Parcel>& parcels,
                           std::size_t more, std::vector<std::size_t>& next) {
  struct One {
    std::size_t block;
    const double* numbers; ///< id, fields, state, and more
  };
  const std::size_t width = numbers_per_particle(set) + more;
  std::vector<One> all;
  for (std::size_t rank = 0; rank < parcels.size(); ++rank) {
    if (parcels[rank].empty())
      continue;
    const auto count = static_cast<std::size_t>(parcels[rank][next[rank]]);
    const double* numbers = parcels[rank].data() + next[rank] + 1;
    for (std::size_t k = 0; k < count; ++k, numbers += width)
      all.push_back({static_cast<std::size_t>(numbers[0]), numbers + 1});
    next[rank] += 1 + count * width;
  }
  std::ranges::stable_sort(all, {}, &One::block);

  std::vector<double> besides;
  set.block_start.assign(blocks + 1, 0);
  set.id.resize(all.size());
  set.state.resize(all.size() * set.state_size);
  std::ranges::fill(set.index_of, Particles::nowhere);
  for (std::size_t k = 0; k < all.size(); ++k) {
    ++set.block_start[all[k].block + 1];
    set.id[k] = static_cast<std::uint32_t>(all[k].numbers[0]);
    set.index_of[set.id[k]] = static_cast<std::uint32_t>(k);
    const double* const state = all[k].numbers + width - 1 - more - set.state_size;
    std::copy_n(state, set.state_size, set.state.begin() + static_cast<std::ptrdiff_t>(k * set.state_size));
    besides.insert(besides.end(), state + set.state_size, state + set.state_size + more);
  }
  std::partial_sum(set.block_start.begin(), set.block_start.end(), set.block_start.begin());
  std::size_t position = 1;
  set.for_fields([&](const ParticleFieldDescription&, std::vector<double>& values) {
    values.resize(all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      values[k] = all[k].numbers[position];
    ++position;
  });
  return besides;
}

void unpack(std::vector<Particles>& sets, std::size_t blocks, const std::vector<Parcel>& parcels) {
  std::vector<std::size_t> next(parcels.size(), 0);
  for (Particles& set : sets)
    unpack(set, blocks, parcels, 0, next);
}

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

/// The load of updates: the time that they take, by what those of the same tile took since the last sort, ns.
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

/// A set of the same soil, to be filled; with the ids of all particles.
Particles without_particles(const Particles& set) {
  Particles empty;
  empty.soil = set.soil;
  empty.soil_index = set.soil_index;
  empty.body = set.body;
  empty.level = set.level;
  empty.cell_size = set.cell_size;
  empty.half_size = set.half_size;
  empty.law = set.law;
  empty.damping_time = set.damping_time;
  empty.relaxation = set.relaxation;
  empty.first_memory = set.first_memory;
  empty.density = set.density;
  empty.weight_share = set.weight_share;
  empty.water = set.water;
  empty.drains = set.drains;
  empty.state_size = set.state_size;
  empty.traits = set.traits;
  empty.more_fields = set.more_fields;
  empty.more.resize(set.more_fields.size());
  empty.index_of.resize(set.index_of.size());
  return empty;
}

std::vector<Parcel> empty_parcels(const Communicator& ranks) {
  return std::vector<Parcel>(static_cast<std::size_t>(ranks.size()));
}

} // namespace

void keep_own_particles(Ground& ground, Communicator& ranks, std::vector<mesh::Rectangle> structures) {
  Census census(ground);
  for (const Particles& set : ground.sets)
    for (std::size_t block = 0; block + 1 < set.block_start.size(); ++block)
      (block < ground.block_count() ? census.on_lattice : census.across)[block % ground.tiles.count()] +=
          static_cast<std::int64_t>(set.block_start[block + 1] - set.block_start[block])
          << ground.clock_of_block(block);
  RankShare& share =
      ground.share.emplace(RankShare{.ranks = &ranks, .deal = {}, .updates = census.of_tiles()});
  share.times.restart(ground.tiles.count());
  weigh_by_time(share, census);
  const Together together = tiles_together(ground, structures, census);
  share.deal = deal_out(ground.tiles, std::move(census.on_lattice), ranks.size(), together);
  share.structures = std::move(structures);
  std::vector<Parcel> parcels(1);
  for (const Particles& set : ground.sets)
    pack(
        set,
        [&](std::size_t, std::size_t block) {
          return ground.share->is_mine(block % ground.tiles.count()) ? 0 : no_rank;
        },
        add_nothing, parcels);
  unpack(ground.sets, ground.block_count() + ground.across_block_count(), parcels);
  resize_fields(ground.grid, ground.grid.size());
}

void make_whole(Ground& ground) {
  Communicator& ranks = *ground.share->ranks;
  std::vector<Parcel> mine(1);
  for (const Particles& set : ground.sets)
    pack(
        set, [](std::size_t, std::size_t) { return 0; }, add_nothing, mine);
  const std::vector<Parcel> to_all(static_cast<std::size_t>(ranks.size()), mine.front());
  unpack(ground.sets, ground.block_count() + ground.across_block_count(), ranks.swap(to_all));
  ground.share.reset();
  resize_fields(ground.grid, ground.grid.size());
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
  share.ranks->add(census.on_lattice);
  if (ground.mesh)
    share.ranks->add(census.across);
  std::vector<std::int64_t> updates = census.of_tiles();
  weigh_by_time(share, census);
  share.updates = std::move(updates);
  share.times.restart(ground.tiles.count());
  const Together together = tiles_together(ground, share.structures, census);
  share.deal = follow(share.deal, ground.tiles, std::move(census.on_lattice), share.ranks->size(), together);
  std::vector<Parcel> parcels = empty_parcels(*share.ranks);
  std::size_t blocks_before = 0;
  for (std::size_t s = 0; s < ground.sets.size(); ++s) {
    pack(
        ground.sets[s], [&](std::size_t k, std::size_t) { return share.owner(tile_of_particle[s][k]); },
        add_nothing, parcels);
    blocks_before = ground.sets[s].block_start.size();
  }
  unpack(ground.sets, blocks_before, share.ranks->swap(parcels));
}

GatheredSets gather_sets(const Ground& ground, const Wanted& wanted, std::size_t more,
                         const AddNumbers& add_numbers) {
  Communicator& ranks = *ground.share->ranks;
  std::vector<Parcel> first(1);
  for (std::size_t s = 0; s < ground.sets.size(); ++s)
    pack(
        ground.sets[s], [&](std::size_t k, std::size_t) { return wanted(s, k) ? 0 : no_rank; },
        [&](std::size_t k, Parcel& parcel) { add_numbers(s, k, parcel); }, first);
  std::vector<Parcel> parcels = empty_parcels(ranks);
  parcels.front() = std::move(first.front());
  const std::vector<Parcel> received = ranks.swap(parcels);
  GatheredSets gathered;
  if (ranks.rank() != 0)
    return gathered;
  std::vector<std::size_t> next(received.size(), 0);
  for (const Particles& set : ground.sets) {
    Particles& copy = gathered.sets.emplace_back(without_particles(set));
    gathered.numbers.push_back(
        unpack(copy, ground.block_count() + ground.across_block_count(), received, more, next));
  }
  return gathered;
}

} // namespace tremolo::mpm_domain
