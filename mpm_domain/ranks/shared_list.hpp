#pragma once

#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/ranks/listed_rows.hpp"

#include <cstddef>
#include <numeric>
#include <span>
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

/// All ranks pass what they know of some lists to each other, in one message.
/// @param numbers  room for it
/// @param rows     ListedRows of SharedLists
template <typename... Rows>
void exchange_all(Communicator& ranks, std::vector<double>& numbers, const Rows&... rows) {
  const auto me = static_cast<std::size_t>(ranks.rank());
  std::vector<int> lengths;
  for (std::size_t rank = 0; rank < static_cast<std::size_t>(ranks.size()); ++rank)
    lengths.push_back(static_cast<int>(((rows.width * rows.list->known_to(rank).size()) + ...)));
  numbers.resize(static_cast<std::size_t>(std::accumulate(lengths.begin(), lengths.end(), 0)));
  double* own = numbers.data() + std::accumulate(lengths.begin(), lengths.begin() + ranks.rank(), 0);
  ((own = read_entries(rows, rows.list->known_to(me), own)), ...);
  ranks.share(numbers, lengths);
  const double* next = numbers.data();
  for (std::size_t rank = 0; rank < lengths.size(); ++rank)
    if (rank == me)
      next += lengths[rank];
    else
      ((next = write_entries(rows, rows.list->known_to(rank), next)), ...);
}

/// The first rank takes what all others know of a list.
/// @param numbers  room for it
template <typename Rows>
void give_to_first(Communicator& ranks, std::vector<double>& numbers, const Rows& rows) {
  const auto me = static_cast<std::size_t>(ranks.rank());
  std::vector<double> part(rows.width * rows.list->known_to(me).size());
  read_entries(rows, rows.list->known_to(me), part.data());
  std::vector<int> lengths;
  for (std::size_t rank = 0; me == 0 && rank < static_cast<std::size_t>(ranks.size()); ++rank)
    lengths.push_back(static_cast<int>(rows.width * rows.list->known_to(rank).size()));
  numbers.resize(static_cast<std::size_t>(std::accumulate(lengths.begin(), lengths.end(), 0)));
  ranks.collect(part, lengths, numbers);
  const double* next = numbers.data();
  for (std::size_t rank = 0; rank < lengths.size(); ++rank)
    next = write_entries(rows, rows.list->known_to(rank), next); // its own as it has them
}

} // namespace tremolo::mpm_domain
