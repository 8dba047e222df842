#include "mpm_domain/particles/share_out.hpp"

#include "mpm_domain/ranks/communicator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Numbers for a rank: for one set after the other the number of particles, and of each particle its tile, its
/// id, its fields and its state.
using Parcel = std::vector<double>;

std::size_t numbers_per_particle(const Particles& set) {
  std::size_t fields = 0;
  set.for_fields([&](const ParticleFieldDescription&, const std::vector<double>&) { ++fields; });
  return 2 + fields + set.state_size;
}

/// Adds a set to the parcels of ranks.
/// @param rank_of  (particle, tile) the rank that is to have it
template <typename RankOf>
void pack(const Particles& set, const RankOf& rank_of, std::vector<Parcel>& parcels) {
  std::vector<const std::vector<double>*> fields;
  set.for_fields([&](const ParticleFieldDescription&, const std::vector<double>& values) {
    fields.push_back(&values);
  });
  std::vector<std::size_t> count_at;
  for (Parcel& parcel : parcels) {
    count_at.push_back(parcel.size());
    parcel.push_back(0.0);
  }
  for (std::size_t tile = 0; tile + 1 < set.block_start.size(); ++tile)
    for (std::size_t k = set.block_start[tile]; k < set.block_start[tile + 1]; ++k) {
      const auto rank = static_cast<std::size_t>(rank_of(k, tile));
      Parcel& parcel = parcels[rank];
      parcel[count_at[rank]] += 1.0;
      parcel.push_back(static_cast<double>(tile));
      parcel.push_back(static_cast<double>(set.id[k]));
      for (const std::vector<double>* field : fields)
        parcel.push_back((*field)[k]);
      const auto state = set.state.begin() + static_cast<std::ptrdiff_t>(k * set.state_size);
      parcel.insert(parcel.end(), state, state + static_cast<std::ptrdiff_t>(set.state_size));
    }
}

/// Fills a set with its particles from parcels, by their tiles. A tile's particles come from one rank.
/// @param next  where the set begins in each parcel; then where it ends
void unpack(Particles& set, std::size_t tiles, const std::vector<Parcel>& parcels,
            std::vector<std::size_t>& next) {
  struct One {
    std::size_t tile;
    const double* numbers; ///< id, fields, state
  };
  const std::size_t width = numbers_per_particle(set);
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

  set.block_start.assign(tiles + 1, 0);
  set.id.resize(all.size());
  set.state.resize(all.size() * set.state_size);
  std::ranges::fill(set.index_of, Particles::nowhere);
  for (std::size_t k = 0; k < all.size(); ++k) {
    ++set.block_start[all[k].tile + 1];
    set.id[k] = static_cast<std::uint32_t>(all[k].numbers[0]);
    set.index_of[set.id[k]] = static_cast<std::uint32_t>(k);
    std::copy_n(all[k].numbers + width - 1 - set.state_size, set.state_size,
                set.state.begin() + static_cast<std::ptrdiff_t>(k * set.state_size));
  }
  std::partial_sum(set.block_start.begin(), set.block_start.end(), set.block_start.begin());
  std::size_t place = 1;
  set.for_fields([&](const ParticleFieldDescription&, std::vector<double>& values) {
    values.resize(all.size());
    for (std::size_t k = 0; k < all.size(); ++k)
      values[k] = all[k].numbers[place];
    ++place;
  });
}

void unpack(std::vector<Particles>& sets, std::size_t tiles, const std::vector<Parcel>& parcels) {
  std::vector<std::size_t> next(parcels.size(), 0);
  for (Particles& set : sets)
    unpack(set, tiles, parcels, next);
}

std::vector<Parcel> empty_parcels(const Communicator& ranks) {
  return std::vector<Parcel>(static_cast<std::size_t>(ranks.size()));
}

} // namespace

std::optional<std::string> not_for_ranks(const Spec& spec) {
  if (!spec.refine.empty())
    return "a mesh of several levels";
  if (spec.water)
    return "soil below a water table";
  if (!spec.structures.empty())
    return "a structure";
  if (spec.sides == Sides::periodic || spec.sides == Sides::periodic_springs)
    return "a domain with periodic sides";
  if (!spec.matched_sides.empty())
    return "a matched layer";
  if (spec.scheme.dispersion == Dispersion::reduced)
    return "a domain with reduced dispersion";
  return std::nullopt;
}

void share_out(Domain& domain, Communicator& ranks) {
  if (const auto what = not_for_ranks(domain.spec))
    throw std::invalid_argument(
        fmt::format("{} cannot be shared out among ranks yet: one rank with more threads runs it", *what));
  std::vector<std::int64_t> particles(domain.tiles.count(), 0);
  for (const Particles& set : domain.sets)
    for (std::size_t tile = 0; tile < particles.size(); ++tile)
      particles[tile] += static_cast<std::int64_t>(set.block_start[tile + 1] - set.block_start[tile]);
  domain.share = RankShare{&ranks, deal_out(domain.tiles, std::move(particles), ranks.size())};
  std::vector<Parcel> parcels = empty_parcels(ranks);
  for (const Particles& set : domain.sets)
    pack(set, [&](std::size_t, std::size_t tile) { return domain.share->is_mine(tile) ? 0 : 1; }, parcels);
  parcels.resize(1);
  unpack(domain.sets, domain.tiles.count(), parcels);
  resize_fields(domain.grid, domain.grid.size());
  domain.boundary.follow_sort(domain);
  find_reach(domain);
}

void move_between_ranks(Domain& domain) {
  RankShare& share = *domain.share;
  std::vector<std::int64_t> particles(domain.tiles.count(), 0);
  std::vector<std::vector<std::size_t>> tile_of_particle;
  for (const Particles& set : domain.sets) {
    std::vector<std::size_t>& tile = tile_of_particle.emplace_back(set.size());
    for (std::size_t k = 0; k < set.size(); ++k) {
      tile[k] = tile_of(set, k, domain.tiles, 0);
      ++particles[tile[k]];
    }
  }
  share.ranks->add(particles);
  share.deal = follow(share.deal, domain.tiles, std::move(particles), share.ranks->size());
  std::vector<Parcel> parcels = empty_parcels(*share.ranks);
  std::size_t tiles_before = 0;
  for (std::size_t s = 0; s < domain.sets.size(); ++s) {
    pack(
        domain.sets[s], [&](std::size_t k, std::size_t) { return share.owner(tile_of_particle[s][k]); },
        parcels);
    tiles_before = domain.sets[s].block_start.size() - 1;
  }
  unpack(domain.sets, tiles_before, share.ranks->swap(parcels));
}

std::vector<Particles> gather_sets(const Domain& domain) {
  Communicator& ranks = *domain.share->ranks;
  std::vector<Parcel> parcels = empty_parcels(ranks);
  for (const Particles& set : domain.sets)
    pack(set, [](std::size_t, std::size_t) { return 0; }, parcels);
  for (std::size_t rank = 1; rank < parcels.size(); ++rank)
    parcels[rank].clear(); // nothing but counts of 0
  const std::vector<Parcel> received = ranks.swap(parcels);
  if (ranks.rank() != 0)
    return {};
  std::vector<Particles> sets = domain.sets;
  unpack(sets, domain.tiles.count(), received);
  return sets;
}

} // namespace tremolo::mpm_domain
