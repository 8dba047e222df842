#include "mpm_domain/particles/journey.hpp"

#include "mpm_domain/particles/room.hpp"
#include "mpm_domain/ranks/communicator.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// Numbers that a rank sends at a time, unless one of each particle is more.
constexpr std::size_t numbers_at_once = std::size_t{1} << 20;

constexpr std::size_t head_numbers = 2; ///< block and id

/// A quantity of the particles of a set: an array, or one of several that take turns in it.
template <typename Array>
struct ColumnOf {
  Array* array;
  std::size_t first;
  std::size_t step;
};

/// Lists the columns of a set: its fields come first, then the variables of its state.
template <typename Array, typename Set>
std::vector<ColumnOf<Array>> columns_of(Set& set) {
  std::vector<ColumnOf<Array>> columns;
  set.for_fields([&](const ParticleFieldDescription&, Array& values) { columns.push_back({&values, 0, 1}); });
  for (std::size_t s = 0; s < set.state_size; ++s)
    columns.push_back({&set.state, s, set.state_size});
  return columns;
}

/// Joins lists, one behind the other.
std::vector<double> joined(std::vector<std::vector<double>> lists) {
  std::vector<double> all = std::move(lists.front());
  for (std::size_t rank = 1; rank < lists.size(); ++rank) {
    all.insert(all.end(), lists[rank].begin(), lists[rank].end());
    lists[rank] = {};
  }
  return all;
}

} // namespace

Journey::Journey(Communicator& ranks, const Particles& from)
    : ranks_(ranks), from_(from), size_(static_cast<std::uint32_t>(from.size())),
      to_(static_cast<std::size_t>(ranks.size())) {}

std::uint32_t Journey::block_of(std::size_t k) {
  const std::vector<std::size_t>& start = from_.block_start;
  if (k < start[block_])
    block_ = 0;
  while (block_ + 1 < start.size() && k >= start[block_ + 1])
    ++block_;
  return static_cast<std::uint32_t>(block_);
}

void Journey::go(std::size_t k, int rank) {
  to_[static_cast<std::size_t>(rank)].push_back({static_cast<std::uint32_t>(k), block_of(k)});
}

std::size_t Journey::count() const {
  std::int64_t count = 0;
  for (const std::vector<Traveller>& to : to_)
    count += static_cast<std::int64_t>(to.size());
  ranks_.add({&count, 1});
  return static_cast<std::size_t>(count);
}

template <typename Add>
Journey::Lists Journey::exchange(const Add& add) const {
  Lists lists(to_.size());
  for (std::size_t rank = 0; rank < to_.size(); ++rank)
    for (const Traveller& traveller : to_[rank])
      add(traveller, lists[rank]);
  return ranks_.swap(lists);
}

/// Finds who is to be there, from the blocks and ids of those that come.
Journey::Arrived Journey::in_order(const std::vector<double>& heads, std::size_t blocks) const {
  std::vector<Arrival> arrivals;
  for (std::size_t i = 0; i < heads.size(); i += head_numbers)
    arrivals.push_back({static_cast<std::uint32_t>(heads[i]), static_cast<std::uint32_t>(arrivals.size())});
  std::ranges::stable_sort(arrivals, {}, &Arrival::block);
  Arrived arrived;
  arrived.block_start.assign(blocks + 1, 0);
  arrived.sources.reserve(staying_.size() + arrivals.size());
  arrived.ids.reserve(staying_.size() + arrivals.size());
  const auto add = [&](std::uint32_t source, std::size_t block, std::uint32_t id) {
    arrived.sources.push_back(source);
    arrived.ids.push_back(id);
    ++arrived.block_start[block + 1];
  };
  auto next = arrivals.begin();
  const auto add_up_to = [&](std::size_t block) {
    for (; next != arrivals.end() && next->block < block; ++next)
      add(size_ + next->number, next->block,
          static_cast<std::uint32_t>(heads[next->number * head_numbers + 1]));
  };
  std::size_t block = 0;
  for (const std::uint32_t k : staying_) {
    while (block + 1 < from_.block_start.size() && k >= from_.block_start[block + 1])
      ++block;
    add_up_to(block);
    add(k, block, from_.id[k]);
  }
  add_up_to(blocks);
  std::partial_sum(arrived.block_start.begin(), arrived.block_start.end(), arrived.block_start.begin());
  return arrived;
}

/// How many columns go in one message, which is the same on all ranks: all of them where few particles
/// travel.
std::size_t Journey::columns_at_once(std::size_t columns) const {
  std::size_t leaving = 0;
  for (const std::vector<Traveller>& to : to_)
    leaving += to.size();
  auto most = static_cast<double>(leaving);
  ranks_.largest({&most, 1});
  return std::clamp(numbers_at_once / std::max<std::size_t>(static_cast<std::size_t>(most), 1),
                    std::size_t{1}, columns);
}

/// Fills the fields and the state of a set, some columns at a time.
void Journey::bring_columns(const std::vector<std::uint32_t>& sources, Particles& at) const {
  const auto given = columns_of<const std::vector<double>>(from_);
  const auto taken = columns_of<std::vector<double>>(at);
  std::vector<double> state(sources.size() * from_.state_size);
  const std::size_t width = columns_at_once(given.size());
  for (std::size_t first = 0; first < given.size(); first += width) {
    const std::size_t end = std::min(first + width, given.size());
    const std::vector<double> come =
        joined(exchange([&](const Traveller& traveller, std::vector<double>& list) {
          for (std::size_t c = first; c < end; ++c)
            list.push_back((*given[c].array)[traveller.k * given[c].step + given[c].first]);
        }));
    for (std::size_t c = first; c < end; ++c) {
      const ColumnOf<const std::vector<double>>& column = given[c];
      const auto value_of = [&](std::uint32_t source) {
        return source < size_ ? (*column.array)[source * column.step + column.first]
                              : come[(source - size_) * (end - first) + c - first];
      };
      if (column.array == &from_.state) {
        for (std::size_t n = 0; n < sources.size(); ++n)
          state[n * column.step + column.first] = value_of(sources[n]);
        continue;
      }
      std::vector<double> values;
      values.reserve(room_for(sources.size(), c));
      for (const std::uint32_t source : sources)
        values.push_back(value_of(source));
      *taken[c].array = std::move(values);
    }
  }
  at.state = std::move(state);
}

std::vector<double> Journey::bring(const Luggage& luggage, const std::vector<std::uint32_t>& sources) const {
  std::vector<double> brought;
  if (luggage.count == 0)
    return brought;
  const std::vector<double> come = joined(exchange(
      [&](const Traveller& traveller, std::vector<double>& list) { luggage.add(traveller.k, list); }));
  for (const std::uint32_t source : sources)
    if (source >= size_) {
      const auto of_one = come.begin() + static_cast<std::ptrdiff_t>((source - size_) * luggage.count);
      brought.insert(brought.end(), of_one, of_one + static_cast<std::ptrdiff_t>(luggage.count));
    }
  return brought;
}

std::vector<double> Journey::arrive(Particles& at, std::size_t blocks, const Luggage& luggage) {
  Arrived arrived = in_order(joined(exchange([&](const Traveller& traveller, std::vector<double>& list) {
                               list.insert(list.end(), {static_cast<double>(traveller.block),
                                                        static_cast<double>(from_.id[traveller.k])});
                             })),
                             blocks);
  std::vector<double> brought = bring(luggage, arrived.sources);
  bring_columns(arrived.sources, at);
  for (const std::uint32_t id : at.id)
    at.index_of.remove(id);
  at.id = std::move(arrived.ids);
  at.block_start = std::move(arrived.block_start);
  for (std::size_t k = 0; k < at.id.size(); ++k)
    at.index_of.put(at.id[k], k);
  return brought;
}

} // namespace tremolo::mpm_domain
