#include "mpm_domain/gravity/construction/same_squares.hpp"

#include "mpm_domain/particles/journey.hpp"
#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// The squares of a model's lattice.
class Squares {
public:
  Squares(const Box& box, double size) : box_(box), size_(size) {}

  /// Number of the one that a particle stands in.
  std::int64_t of(const Particles& set, std::size_t k) const {
    return along(set.x[k], box_.x_min) * rows + along(set.y[k], box_.y_min);
  }
  /// The rank at which those of its column meet.
  std::size_t rank_of(std::int64_t square, int ranks) const {
    const std::int64_t columns = std::max<std::int64_t>(along(box_.x_max, box_.x_min), 1);
    return static_cast<std::size_t>(std::clamp<std::int64_t>(square / rows, 0, columns - 1) * ranks /
                                    columns);
  }

private:
  static constexpr std::int64_t rows = std::int64_t{1} << 31;

  std::int64_t along(double position, double origin) const {
    return static_cast<std::int64_t>(std::floor((position - origin) / size_));
  }

  Box box_;
  double size_;
};

void meet(const Particles& set, const Particles& former, const Squares& squares, const TakeFormer& take) {
  std::unordered_map<std::int64_t, std::size_t> places;
  for (std::size_t j = 0; j < former.size(); ++j)
    places.emplace(squares.of(former, j), j);
  for (std::size_t k = 0; k < set.size(); ++k)
    if (const auto found = places.find(squares.of(set, k)); found != places.end())
      take(k, former, found->second);
}

using Lists = std::vector<std::vector<double>>; ///< by rank

/// Tells the ranks of their columns the squares and the numbers of particles.
Lists swap_squares(const Particles& set, const Squares& squares, Communicator& ranks) {
  Lists lists(static_cast<std::size_t>(ranks.size()));
  for (std::size_t k = 0; k < set.size(); ++k) {
    const std::int64_t square = squares.of(set, k);
    std::vector<double>& list = lists[squares.rank_of(square, ranks.size())];
    list.insert(list.end(), {static_cast<double>(square), static_cast<double>(k)});
  }
  return ranks.swap(lists);
}

/// A particle that a rank needs.
struct Needed {
  std::size_t k;
  int by;
};

/// The particles of this rank that ranks need, in order.
std::vector<Needed> needed(const Particles& set, const Particles& former, const Squares& squares,
                           Communicator& ranks) {
  struct Place {
    std::size_t rank;
    double k;
  };
  std::unordered_map<std::int64_t, Place> places;
  const Lists had = swap_squares(former, squares, ranks);
  for (std::size_t rank = 0; rank < had.size(); ++rank)
    for (std::size_t n = 0; n < had[rank].size(); n += 2)
      places.emplace(static_cast<std::int64_t>(had[rank][n]), Place{rank, had[rank][n + 1]});
  Lists asked(had.size());
  const Lists wanted = swap_squares(set, squares, ranks);
  for (std::size_t rank = 0; rank < wanted.size(); ++rank)
    for (std::size_t n = 0; n < wanted[rank].size(); n += 2)
      if (const auto found = places.find(static_cast<std::int64_t>(wanted[rank][n])); found != places.end())
        asked[found->second.rank].insert(asked[found->second.rank].end(),
                                         {found->second.k, static_cast<double>(rank)});
  std::vector<Needed> needed;
  for (const std::vector<double>& numbers : ranks.swap(asked))
    for (std::size_t n = 0; n < numbers.size(); n += 2)
      needed.push_back({static_cast<std::size_t>(numbers[n]), static_cast<int>(numbers[n + 1])});
  std::ranges::sort(needed, {}, &Needed::k);
  return needed;
}

} // namespace

void meet_in_squares(const Particles& set, const Particles& former, const Box& box, Communicator* ranks,
                     const TakeFormer& take) {
  const Squares squares(box, 2.0 * set.half_size);
  if (ranks == nullptr)
    return meet(set, former, squares, take);
  Journey journey(*ranks, former);
  for (const auto& [k, by] : needed(set, former, squares, *ranks))
    journey.go(k, by);
  Particles copies = empty_like(former);
  journey.arrive(copies, former.block_start.size());
  meet(set, copies, squares, take);
}

} // namespace tremolo::mpm_domain
