#include "mpm_domain/particles/fill/fill_together.hpp"

#include "mpm_domain/particles/fill/fill.hpp"
#include "mpm_domain/ranks/communicator.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Particles of the whole ground that a set has on lower ranks, and on all.
struct Numbering {
  std::int64_t before = 0;
  std::int64_t all = 0;
};

std::vector<Numbering> numbering_of(const std::vector<Particles>& sets, Communicator& ranks) {
  const auto rank_count = static_cast<std::size_t>(ranks.size());
  const auto own = static_cast<std::size_t>(ranks.rank());
  std::vector<std::int64_t> sizes(sets.size() * rank_count, 0); // [set][rank]
  for (std::size_t s = 0; s < sets.size(); ++s)
    sizes[s * rank_count + own] = static_cast<std::int64_t>(sets[s].size());
  ranks.add(sizes);
  std::vector<Numbering> numbering(sets.size());
  for (std::size_t s = 0; s < sets.size(); ++s)
    for (std::size_t rank = 0; rank < rank_count; ++rank) {
      const std::int64_t size = sizes[s * rank_count + rank];
      numbering[s].before += rank < own ? size : 0;
      numbering[s].all += size;
    }
  return numbering;
}

/// The particles of a set on this rank are a block, and can be found by their ids.
/// @param all  of all ranks
void become_block(Particles& set, std::size_t all, const Communicator& ranks) {
  set.block_start.assign(static_cast<std::size_t>(ranks.rank()) + 1, 0);
  set.block_start.resize(static_cast<std::size_t>(ranks.size()), set.size());
  set.index_of.give(all);
  for (std::size_t k = 0; k < set.size(); ++k)
    set.index_of.put(set.id[k], k);
}

/// Particles that several ranks have filled take the numbers that one would have given them. Until the
/// first sort those of each rank are a block.
void number_over_ranks(std::vector<Particles>& sets, Communicator& ranks) {
  const std::vector<Numbering> numbering = numbering_of(sets, ranks);
  constexpr std::int64_t most = Particles::nowhere;
  bool is_empty = true;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const auto [before, all] = numbering[s];
    if (all > most)
      throw std::invalid_argument(fmt::format(
          "the soil '{}' has {} particles of one size; allowed: {} at the most", sets[s].soil, all, most));
    for (std::uint32_t& id : sets[s].id)
      id += static_cast<std::uint32_t>(before);
    become_block(sets[s], static_cast<std::size_t>(all), ranks);
    is_empty &= all == 0;
  }
  if (is_empty)
    throw std::invalid_argument(no_particle);
}

} // namespace

std::vector<Particles> fill_together(const Spec& spec, const std::optional<Head>& head,
                                     const mesh::Quadtree* tree, Communicator& ranks) {
  std::vector<Particles> sets = fill(spec, head, tree, &ranks);
  number_over_ranks(sets, ranks);
  return sets;
}

void leave_to_first(std::span<Particles> sets, const Communicator& ranks) {
  for (Particles& set : sets) {
    const std::size_t all = set.size();
    if (ranks.rank() != 0)
      set = empty_like(set);
    become_block(set, all, ranks);
  }
}

} // namespace tremolo::mpm_domain
