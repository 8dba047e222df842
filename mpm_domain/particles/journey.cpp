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

/// Those of the fields, then those of the state.
template <typename Array, typename Set>
std::vector<ColumnOf<Array>> columns_of(Set& set) {
  std::vector<ColumnOf<Array>> columns;
  set.for_fields([&](const ParticleFieldDescription&, Array& values) { columns.push_back({&values, 0, 1}); });
  for (std::size_t s = 0; s < set.state_size; ++s)
    columns.push_back({&set.state, s, set.state_size});
  return columns;
}

/// One list behind the other.
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
    : ranks_(ranks), from_(from), to_(static_cast<std::size_t>(ranks.size())) {}

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

/// The particles that are to be, in their order: those that stay by their numbers, and behind these, those
/// that come.
std::vector<std::uint32_t> Journey::order_of(const Lists& heads) const {
  std::vector<Arrival> arrivals;
  for (const std::vector<double>& head : heads)
    for (std::size_t i = 0; i < head.size(); i += head_numbers)
      arrivals.push_back({static_cast<std::uint32_t>(head[i]), static_cast<std::uint32_t>(arrivals.size())});
  std::ranges::stable_sort(arrivals, {}, &Arrival::block);
  std::vector<std::uint32_t> order;
  order.reserve(staying_.size() + arrivals.size());
  auto next = arrivals.begin();
  std::size_t block = 0;
  for (const std::uint32_t k : staying_) {
    while (block + 1 < from_.block_start.size() && k >= from_.block_start[block + 1])
      ++block;
    for (; next != arrivals.end() && next->block < block; ++next)
      order.push_back(static_cast<std::uint32_t>(from_.size()) + next->number);
    order.push_back(k);
  }
  for (; next != arrivals.end(); ++next)
    order.push_back(static_cast<std::uint32_t>(from_.size()) + next->number);
  return order;
}

/// The same on all ranks: all columns, where few particles are on the way.
std::size_t Journey::columns_at_once(std::size_t columns) const {
  std::size_t leaving = 0;
  for (const std::vector<Traveller>& to : to_)
    leaving += to.size();
  auto most = static_cast<double>(leaving);
  ranks_.largest({&most, 1});
  return std::clamp(numbers_at_once / std::max<std::size_t>(static_cast<std::size_t>(most), 1),
                    std::size_t{1}, columns);
}

std::vector<double> Journey::arrive(Particles& at, std::size_t blocks, const Luggage& luggage) {
  Lists heads = exchange([&](const Traveller& traveller, std::vector<double>& list) {
    list.insert(list.end(),
                {static_cast<double>(traveller.block), static_cast<double>(from_.id[traveller.k])});
  });
  const std::vector<std::uint32_t> order = order_of(heads);
  const auto before = static_cast<std::uint32_t>(from_.size());

  const std::vector<double> head = joined(std::move(heads));
  std::vector<std::uint32_t> ids;
  std::vector<std::size_t> start(blocks + 1, 0);
  ids.reserve(order.size());
  std::size_t block = 0;
  for (const std::uint32_t source : order) {
    if (source < before) {
      ids.push_back(from_.id[source]);
      while (block + 1 < from_.block_start.size() && source >= from_.block_start[block + 1])
        ++block;
      ++start[block + 1];
    } else {
      const double* const of_one = &head[(source - before) * head_numbers];
      ids.push_back(static_cast<std::uint32_t>(of_one[1]));
      ++start[static_cast<std::size_t>(of_one[0]) + 1];
    }
  }
  std::partial_sum(start.begin(), start.end(), start.begin());

  const auto sources = columns_of<const std::vector<double>>(from_);
  std::vector<double> state(order.size() * from_.state_size);
  auto targets = columns_of<std::vector<double>>(at);
  const std::size_t width = columns_at_once(sources.size());
  for (std::size_t first = 0; first < sources.size(); first += width) {
    const std::size_t end = std::min(first + width, sources.size());
    const std::vector<double> come =
        joined(exchange([&](const Traveller& traveller, std::vector<double>& list) {
          for (std::size_t c = first; c < end; ++c)
            list.push_back((*sources[c].array)[traveller.k * sources[c].step + sources[c].first]);
        }));
    for (std::size_t c = first; c < end; ++c) {
      const auto& [array, offset, step] = sources[c];
      const auto value_of = [&](std::uint32_t source) {
        return source < before ? (*array)[source * step + offset]
                               : come[(source - before) * (end - first) + c - first];
      };
      if (array == &from_.state) {
        for (std::size_t n = 0; n < order.size(); ++n)
          state[n * step + offset] = value_of(order[n]);
        continue;
      }
      std::vector<double> values;
      values.reserve(room_for(order.size(), c));
      for (const std::uint32_t source : order)
        values.push_back(value_of(source));
      *targets[c].array = std::move(values);
    }
  }
  std::vector<double> besides;
  if (luggage.count > 0) {
    const std::vector<double> come = joined(exchange(
        [&](const Traveller& traveller, std::vector<double>& list) { luggage.add(traveller.k, list); }));
    for (const std::uint32_t source : order)
      if (source >= before) {
        const auto of_one = come.begin() + static_cast<std::ptrdiff_t>((source - before) * luggage.count);
        besides.insert(besides.end(), of_one, of_one + static_cast<std::ptrdiff_t>(luggage.count));
      }
  }

  if (&at == &from_)
    for (const std::uint32_t id : at.id)
      at.index_of.remove(id);
  at.id = std::move(ids);
  at.state = std::move(state);
  at.block_start = std::move(start);
  for (std::size_t k = 0; k < at.id.size(); ++k)
    at.index_of.put(at.id[k], k);
  return besides;
}

} // namespace tremolo::mpm_domain
