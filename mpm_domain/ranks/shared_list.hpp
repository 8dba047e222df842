#pragma once

#include "mpm_domain/ranks/communicator.hpp"

#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

/// Entries of a list that all ranks have, of which each is known to one rank.
class SharedList {
public:
  SharedList() = default;
  /// @param owner  the rank that knows an entry, by entry; nobody: left out
  SharedList(const std::vector<int>& owner, const Communicator& ranks)
      : of_rank_(static_cast<std::size_t>(ranks.size())) {
    for (std::size_t entry = 0; entry < owner.size(); ++entry)
      if (owner[entry] != nobody)
        of_rank_[static_cast<std::size_t>(owner[entry])].push_back(entry);
  }

  static constexpr int nobody = -1;

  std::span<const std::size_t> known_to(std::size_t rank) const { return of_rank_[rank]; }

private:
  std::vector<std::vector<std::size_t>> of_rank_;
};

/// The numbers of a list that ranks exchange.
template <typename Read, typename Write>
struct SharedRows {
  const SharedList* list;
  std::size_t width; ///< numbers of an entry
  Read read;         ///< (entry, numbers) gives those of an entry that this rank knows
  Write write;       ///< (entry, numbers) takes those of another
};
template <typename Read, typename Write>
SharedRows(const SharedList*, std::size_t, Read, Write) -> SharedRows<Read, Write>;

/// All ranks pass what they know of some lists to each other, in one message.
/// @param numbers  room for it
template <typename... Lists>
void exchange_all(Communicator& ranks, std::vector<double>& numbers, const Lists&... lists) {
  const auto me = static_cast<std::size_t>(ranks.rank());
  std::vector<int> lengths;
  for (std::size_t rank = 0; rank < static_cast<std::size_t>(ranks.size()); ++rank)
    lengths.push_back(static_cast<int>(((lists.width * lists.list->known_to(rank).size()) + ...)));
  numbers.resize(static_cast<std::size_t>(std::accumulate(lengths.begin(), lengths.end(), 0)));
  // act(list, entry, its numbers) for what a rank knows.
  const auto walk = [&](std::size_t rank, double* next, const auto& act) {
    const auto walk_list = [&](const auto& rows) {
      for (const std::size_t entry : rows.list->known_to(rank)) {
        act(rows, entry, next);
        next += rows.width;
      }
    };
    (walk_list(lists), ...);
    return next;
  };
  const int before = std::accumulate(lengths.begin(), lengths.begin() + ranks.rank(), 0);
  walk(me, numbers.data() + before,
       [](const auto& rows, std::size_t entry, double* its) { rows.read(entry, its); });
  ranks.share(numbers, lengths);
  double* next = numbers.data();
  for (std::size_t rank = 0; rank < lengths.size(); ++rank)
    next = rank == me ? next + lengths[rank]
                      : walk(rank, next, [](const auto& rows, std::size_t entry, const double* its) {
                          rows.write(entry, its);
                        });
}

/// The first rank takes what all others know of a list.
/// @param numbers  room for it
template <typename Rows>
void give_to_first(Communicator& ranks, std::vector<double>& numbers, const Rows& rows) {
  const auto me = static_cast<std::size_t>(ranks.rank());
  std::vector<double> part;
  for (const std::size_t entry : rows.list->known_to(me)) {
    part.resize(part.size() + rows.width);
    rows.read(entry, part.data() + part.size() - rows.width);
  }
  std::vector<int> lengths;
  for (std::size_t rank = 0; me == 0 && rank < static_cast<std::size_t>(ranks.size()); ++rank)
    lengths.push_back(static_cast<int>(rows.width * rows.list->known_to(rank).size()));
  numbers.resize(static_cast<std::size_t>(std::accumulate(lengths.begin(), lengths.end(), 0)));
  ranks.collect(part, lengths, numbers);
  const double* next = numbers.data();
  for (std::size_t rank = 0; rank < lengths.size(); ++rank)
    for (const std::size_t entry : rows.list->known_to(rank)) {
      if (rank != me)
        rows.write(entry, next);
      next += rows.width;
    }
}

} // namespace tremolo::mpm_domain
