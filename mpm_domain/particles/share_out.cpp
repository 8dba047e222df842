#include "mpm_domain/particles/share_out.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Numbers for a rank: for one set after the other the number of particles, and of each particle its tile,
/// its id, its fields, its state, and what goes with it besides.
using Parcel = std::vector<double>;

constexpr int no_rank = -1;

/// Nothing goes with the particles.
void add_nothing(std::size_t /*k*/, Parcel& /*parcel*/) {}

std::size_t numbers_per_particle(const Particles& set) {
  std::size_t fields = 0;
  set.for_fields([&](const ParticleFieldDescription&, const std::vector<double>&) { ++fields; });
  return 2 + fields + set.state_size;
}

/// Adds a set to the parcels of ranks.
/// @param rank_of   (particle, tile) the rank that is to have it, or no_rank
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
  for (std::size_t tile = 0; tile + 1 < set.block_start.size(); ++tile)
    for (std::size_t k = set.block_start[tile]; k < set.block_start[tile + 1]; ++k) {
      const int to = rank_of(k, tile);
      if (to == no_rank)
        continue;
      const auto rank = static_cast<std::size_t>(to);
      Parcel& parcel = parcels[rank];
      parcel[count_at[rank]] += 1.0;
      parcel.push_back(static_cast<double>(tile));
      parcel.push_back(static_cast<double>(set.id[k]));
      for (const std::vector<double>* field : fields)
        parcel.push_back((*field)[k]);
      const auto state = set.state.begin() + static_cast<std::ptrdiff_t>(k * set.state_size);
      parcel.insert(parcel.end(), state, state + static_cast<std::ptrdiff_t>(set.state_size));
      add_more(k, parcel);
    }
}

/// Fills a set with its particles from parcels, by their tiles. A tile's particles come from one rank.
/// @param more  how many numbers go with a particle besides
/// @param next  where the set begins in each parcel; then where it ends
/// @returns these numbers, particle after particle
std::vector<double> unpack(Particles& set, std::size_t tiles, const std::vector<Parcel>& parcels,
                           std::size_t more, std::vector<std::size_t>& next) {
  struct One {
    std::size_t tile;
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
  std::ranges::stable_sort(all, {}, &One::tile);

  std::vector<double> besides;
  set.block_start.assign(tiles + 1, 0);
  set.id.resize(all.size());
  set.state.resize(all.size() * set.state_size);
  std::ranges::fill(set.index_of, Particles::nowhere);
  for (std::size_t k = 0; k < all.size(); ++k) {
    ++set.block_start[all[k].tile + 1];
    set.id[k] = static_cast<std::uint32_t>(all[k].numbers[0]);
    set.index_of[set.id[k]] = static_cast<std::uint32_t>(k);
    const double* const state = all[k].numbers + width - 1 - more - set.state_size;
    std::copy_n(state, set.state_size, set.state.begin() + static_cast<std::ptrdiff_t>(k * set.state_size));
    besides.insert(besides.end(), state + set.state_size, state + set.state_size + more);
  }
  std::partial_sum(set.block_start.begin(), set.block_start.end(), set.block_start.begin());
  std::size_t place = 1;
  set.for_fields([&](const ParticleFieldDescription&, std::vector<double>& values) {
    values.resize(all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      values[k] = all[k].numbers[place];
    ++place;
  });
  return besides;
}

void unpack(std::vector<Particles>& sets, std::size_t tiles, const std::vector<Parcel>& parcels) {
  std::vector<std::size_t> next(parcels.size(), 0);
  for (Particles& set : sets)
    unpack(set, tiles, parcels, 0, next);
}

/// What of a domain ranks cannot share yet.
std::optional<std::string> not_for_ranks(const Spec& spec) {
  if (!spec.refine.empty())
    return "a mesh of several levels";
  if (!spec.earthworks.empty())
    return "soil that is placed or removed after a shaking";
  if (spec.sides == Sides::periodic || spec.sides == Sides::periodic_springs)
    return "a domain with periodic sides";
  if (spec.scheme.dispersion == Dispersion::reduced)
    return "a domain with reduced dispersion";
  return std::nullopt;
}

/// Of each row of tiles those that hold nodes of periodic sides: images, and what they are images of. Sums at
/// both come together on one rank.
std::vector<std::vector<std::size_t>> tiles_of_images(const Ground& ground) {
  const Grid& grid = ground.grid;
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

/// Tiles that structures, in these boxes, may touch, and all of elastic bodies, are the first rank's.
Together tiles_together(const Ground& ground, std::span<const mesh::Rectangle> structures) {
  Together together;
  const auto is_touched = [&](std::size_t tile) {
    return ground.tiles.level_of(tile) >= ground.soil_lattice_count() ||
           std::ranges::any_of(structures,
                               [&](const mesh::Rectangle& box) { return ground.tiles.reaches(tile, box); });
  };
  for (std::size_t tile = 0; tile < ground.tiles.count(); ++tile)
    if (is_touched(tile))
      together.of_first.push_back(tile);
  for (std::vector<std::size_t>& group : tiles_of_images(ground))
    if (std::ranges::any_of(group, is_touched))
      together.of_first.insert(together.of_first.end(), group.begin(), group.end());
    else
      together.groups.push_back(std::move(group));
  std::ranges::sort(together.of_first);
  const auto twice = std::ranges::unique(together.of_first);
  together.of_first.erase(twice.begin(), twice.end());
  return together;
}

std::vector<Parcel> empty_parcels(const Communicator& ranks) {
  return std::vector<Parcel>(static_cast<std::size_t>(ranks.size()));
}

} // namespace

void require_shareable(const Spec& spec) {
  if (const auto what = not_for_ranks(spec))
    throw std::invalid_argument(
        fmt::format("ranks cannot share {} yet: leave out --ranks and take more --threads", *what));
}

void keep_own_particles(Ground& ground, Communicator& ranks, std::vector<mesh::Rectangle> structures) {
  require_shareable(ground.spec);
  std::vector<std::int64_t> particles(ground.tiles.count(), 0);
  for (const Particles& set : ground.sets)
    for (std::size_t tile = 0; tile < particles.size(); ++tile)
      particles[tile] += static_cast<std::int64_t>(set.block_start[tile + 1] - set.block_start[tile]);
  const Together together = tiles_together(ground, structures);
  ground.share = RankShare{&ranks, deal_out(ground.tiles, std::move(particles), ranks.size(), together),
                           std::move(structures)};
  std::vector<Parcel> parcels(1);
  for (const Particles& set : ground.sets)
    pack(
        set, [&](std::size_t, std::size_t tile) { return ground.share->is_mine(tile) ? 0 : no_rank; },
        add_nothing, parcels);
  unpack(ground.sets, ground.tiles.count(), parcels);
  resize_fields(ground.grid, ground.grid.size());
}

void move_between_ranks(Ground& ground) {
  RankShare& share = *ground.share;
  std::vector<std::int64_t> particles(ground.tiles.count(), 0);
  std::vector<std::vector<std::size_t>> tile_of_particle;
  for (const Particles& set : ground.sets) {
    std::vector<std::size_t>& tile = tile_of_particle.emplace_back(set.size());
    const int level = set.body ? ground.soil_lattice_count() + static_cast<int>(*set.body) : 0;
    for (std::size_t k = 0; k < set.size(); ++k) {
      tile[k] = tile_of(set, k, ground.tiles, level);
      ++particles[tile[k]];
    }
  }
  share.ranks->add(particles);
  share.deal = follow(share.deal, ground.tiles, std::move(particles), share.ranks->size(),
                      tiles_together(ground, share.structures));
  std::vector<Parcel> parcels = empty_parcels(*share.ranks);
  std::size_t tiles_before = 0;
  for (std::size_t s = 0; s < ground.sets.size(); ++s) {
    pack(
        ground.sets[s], [&](std::size_t k, std::size_t) { return share.owner(tile_of_particle[s][k]); },
        add_nothing, parcels);
    tiles_before = ground.sets[s].block_start.size() - 1;
  }
  unpack(ground.sets, tiles_before, share.ranks->swap(parcels));
}

GatheredSets gather_sets(const Ground& ground, const Wanted& wanted, std::size_t more,
                         const AddNumbers& add_numbers) {
  Communicator& ranks = *ground.share->ranks;
  std::vector<Parcel> parcels = empty_parcels(ranks);
  std::vector<Parcel> first(1);
  for (std::size_t s = 0; s < ground.sets.size(); ++s)
    pack(
        ground.sets[s], [&](std::size_t k, std::size_t) { return !wanted || wanted(s, k) ? 0 : no_rank; },
        [&](std::size_t k, Parcel& parcel) {
          if (add_numbers)
            add_numbers(s, k, parcel);
        },
        first);
  parcels.front() = std::move(first.front());
  const std::vector<Parcel> received = ranks.swap(parcels);
  GatheredSets gathered;
  if (ranks.rank() != 0)
    return gathered;
  gathered.sets = ground.sets;
  std::vector<std::size_t> next(received.size(), 0);
  for (Particles& set : gathered.sets)
    gathered.numbers.push_back(unpack(set, ground.tiles.count(), received, more, next));
  return gathered;
}

} // namespace tremolo::mpm_domain
